// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listingrun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const QString assigns = QStringLiteral(" ← ");

} // namespace

void ListingRun::run()
{
    const auto isOfLoops = [](const PseudocodeLine &line) {
        return std::ranges::find(line.moments, Moment::SetUp) == line.moments.end()
            && std::ranges::find(line.moments, Moment::Rejected) == line.moments.end();
    };
    const auto first = std::ranges::find_if(m_code, isOfLoops);
    m_names[QStringLiteral("x_min")] = Number(m_box.firstX);
    m_names[QStringLiteral("y_min")] = Number(m_box.firstY);
    runBlock(std::size_t(first - m_code.begin()), m_code.size());
}

/// One past the lines that stand deeper than a line and below it.
std::size_t ListingRun::endOfBlock(std::size_t line) const
{
    std::size_t end = line + 1;
    while (end < m_code.size() && m_code[end].depth > m_code[line].depth)
        ++end;
    return end;
}

void ListingRun::runBlock(std::size_t first, std::size_t end)
{
    for (std::size_t line = first; line < end; line = endOfBlock(line))
        runLine(line);
}

void ListingRun::runLine(std::size_t line)
{
    const QString text = m_code[line].text.section(QStringLiteral(" — "), 0, 0);
    const QString loop = QStringLiteral("for each ");
    if (text.startsWith(loop) && text.endsWith(QStringLiteral(" of the box:")))
        return runLoop(line, text.sliced(loop.size(), 1));
    if (text.startsWith(QStringLiteral("if ")) && text.endsWith(u':')) {
        if (holds(text.sliced(3).chopped(1)))
            runBlock(line + 1, endOfBlock(line));
        return;
    }
    if (text == QStringLiteral("pixel (x, y) ← the bytes of R, G, B"))
        return draw();
    for (const QString &statement : spelledOut(text))
        runStatement(statement);
}

void ListingRun::runLoop(std::size_t line, const QString &name)
{
    const bool isX = name == QStringLiteral("x");
    const std::int64_t end = isX ? m_box.endX : m_box.endY;
    for (std::int64_t at = isX ? m_box.firstX : m_box.firstY; at < end; ++at) {
        m_names[name] = Number(at);
        runBlock(line + 1, endOfBlock(line));
    }
}

void ListingRun::runStatement(const QString &text)
{
    if (text.startsWith(QStringLiteral("add ")))
        add(text);
    else if (text.contains(assigns))
        assign(text);
    else
        throw ListingFault(QStringLiteral("does nothing: ") + text);
}

/// All values are read before the first is written.
void ListingRun::assign(const QString &statement)
{
    const QStringList names = statement.section(assigns, 0, 0).split(QStringLiteral(", "));
    const QStringList expressions = statement.section(assigns, 1).split(QStringLiteral(", "));
    if (names.size() != expressions.size())
        throw ListingFault(QStringLiteral("unequal sides: ") + statement);
    std::vector<Number> values;
    for (const QString &expression : expressions)
        values.push_back(valueOf(expression));
    for (qsizetype i = 0; i < names.size(); ++i)
        m_names[names[i]] = values[std::size_t(i)];
}

void ListingRun::add(const QString &statement)
{
    const QString to = QStringLiteral(" to ");
    const QStringList changes = statement.sliced(4).section(to, 0, 0).split(QStringLiteral(", "));
    const QStringList names = statement.section(to, 1).split(QStringLiteral(", "));
    if (names.size() != changes.size())
        throw ListingFault(QStringLiteral("unequal sides: ") + statement);
    for (qsizetype i = 0; i < names.size(); ++i) {
        const Number change = valueOf(changes[i]);
        m_names[names[i]] = valueOf(names[i]) + change;
    }
}

void ListingRun::draw()
{
    const auto byte = [this](const char *channel) {
        const Number level = valueOf(QString::fromLatin1(channel)) + Number(1, 2);
        // Towards 0, which is down where levels are not negative.
        const BigInteger whole = numerator(level) / denominator(level);
        return std::clamp(whole.convert_to<int>(), 0, 255);
    };
    const auto place = [this](const char *axis) {
        return numerator(valueOf(QString::fromLatin1(axis))).convert_to<std::int64_t>();
    };
    m_pixels[{place("x"), place("y")}] = qRgb(byte("R"), byte("G"), byte("B"));
}

bool ListingRun::holds(const QString &condition) const
{
    const QStringList tests = spelledOut(condition);
    return std::ranges::all_of(tests, [this](const QString &test) { return holdsOne(test); });
}

/// "A > 0, or A = 0 and B > 0".
bool ListingRun::holdsOne(const QString &test) const
{
    const QStringList ways = test.split(QStringLiteral(", or "));
    return std::ranges::any_of(ways, [this](const QString &way) {
        const QStringList comparisons = way.split(QStringLiteral(" and "));
        return std::ranges::all_of(comparisons,
                                   [this](const QString &each) { return holdsChain(each); });
    });
}

/// "0 ≤ α ≤ 1".
bool ListingRun::holdsChain(const QString &comparison) const
{
    const QString signs = QStringLiteral("<≤=≥>");
    std::vector<Number> values;
    QString between, side;
    const auto end = [&] { values.push_back(valueOf(side.trimmed())); };
    for (const QChar character : comparison) {
        if (!signs.contains(character)) {
            side += character;
            continue;
        }
        end();
        side.clear();
        between += character;
    }
    end();
    if (between.isEmpty())
        throw ListingFault(QStringLiteral("compares nothing: ") + comparison);
    for (qsizetype i = 0; i < between.size(); ++i) {
        const Number &a = values[std::size_t(i)];
        const Number &b = values[std::size_t(i) + 1];
        const QChar sign = between[i];
        const bool isTrue = (sign == u'<' && a < b) || (sign == u'≤' && a <= b)
            || (sign == u'=' && a == b) || (sign == u'≥' && a >= b) || (sign == u'>' && a > b);
        if (!isTrue)
            return false;
    }
    return true;
}

ListingRun::Number ListingRun::valueOf(const QString &expression) const
{
    return pixelplumb::valueOf(expression, m_names);
}

} // namespace pixelplumb
