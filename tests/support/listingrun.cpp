// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listingrun.h"

#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb {

namespace {

const QString assigns = QStringLiteral(" ← ");

QString withoutRemark(const QString &line) { return line.section(QStringLiteral(" — "), 0, 0); }

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
    runSetUp(std::size_t(first - m_code.begin()));
    runBlock(std::size_t(first - m_code.begin()), m_code.size());
}

/// Runs only choices between two values; other set-up names get their values from the numbers.
void ListingRun::runSetUp(std::size_t end)
{
    for (std::size_t line = 0; line < end; ++line) {
        const QString text = withoutRemark(m_code[line].text);
        const QString name = text.section(assigns, 0, 0);
        if (text.contains(QStringLiteral(", else ")) && !name.contains(u' ')
            && !m_names.contains(name))
            runStatement(text);
    }
}

/// One past the lines below a line that are nested in it.
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
    const QString text = withoutRemark(m_code[line].text);
    if (!runLoop(line, text) && !runCase(line, text))
        runStatements(text);
}

/// False if the line is no loop.
bool ListingRun::runLoop(std::size_t line, const QString &text)
{
    static const QRegularExpression ofBox(QStringLiteral("^for each (x|y) of the box:$"));
    static const QRegularExpression ofRange(
        QStringLiteral("^for each (?:\\w+ )?(\\S+)(?: = i/(\\S+))? from (.+) to (.+):$"),
        QRegularExpression::UseUnicodePropertiesOption);
    if (const auto match = ofBox.match(text); match.hasMatch()) {
        const bool isX = match.captured(1) == QStringLiteral("x");
        const std::int64_t end = isX ? m_box.endX : m_box.endY;
        for (std::int64_t at = isX ? m_box.firstX : m_box.firstY; at < end; ++at)
            runBlockWith(line, match.captured(1), Number(at));
        return true;
    }
    const auto match = ofRange.match(text);
    if (!match.hasMatch())
        return false;
    const Number step
        = match.captured(2).isEmpty() ? Number(1) : Number(1) / valueOf(match.captured(2));
    const Number last = chosenValue(match.captured(4));
    const bool wasFirst = m_isFirst;
    m_isFirst = true;
    for (Number at = valueOf(match.captured(3)); at <= last; at += step) {
        runBlockWith(line, match.captured(1), at);
        m_isFirst = false;
    }
    m_isFirst = wasFirst;
    return true;
}

void ListingRun::runBlockWith(std::size_t line, const QString &name, const Number &value)
{
    m_names[name] = value;
    m_hasCase = false;
    runBlock(line + 1, endOfBlock(line));
}

/// False if the line is no case.
bool ListingRun::runCase(std::size_t line, const QString &text)
{
    const QString first = QStringLiteral("the first:"), otherwise = QStringLiteral("else:"),
                  ifElse = QStringLiteral("else if "), onlyIf = QStringLiteral("if ");
    bool isTaken = false;
    if (text.startsWith(first))
        isTaken = m_isFirst;
    else if (text.startsWith(otherwise))
        isTaken = !m_hasCase;
    else if (text.startsWith(ifElse))
        isTaken = !m_hasCase && holds(text.sliced(ifElse.size()).section(u':', 0, 0));
    else if (text.startsWith(onlyIf))
        isTaken = holds(text.sliced(onlyIf.size()).section(u':', 0, 0));
    else
        return false;
    const bool hadCase = m_hasCase && text.startsWith(u'e');
    const QString statements = text.section(u':', 1).trimmed();
    if (isTaken && !statements.isEmpty())
        runStatements(statements);
    if (isTaken)
        runBlock(line + 1, endOfBlock(line));
    m_hasCase = isTaken || hadCase;
    return true;
}

void ListingRun::runStatements(const QString &text)
{
    for (const QString &statement : spelledOut(text))
        runStatement(statement);
}

void ListingRun::runStatement(const QString &text)
{
    static const QRegularExpression pixel(
        QStringLiteral("^pixel \\((.+)\\) ← (?:the bytes of R, G, B|colour)$"));
    if (const auto match = pixel.match(text); match.hasMatch())
        draw(match.captured(1));
    else if (text.startsWith(QStringLiteral("add ")))
        add(text);
    else if (text.contains(assigns))
        assign(text);
    else
        throw ListingFault(QStringLiteral("does nothing: ") + text);
}

/// "1 if y₁ ≥ y₀, else −1", which is never part of an expression, or a plain expression.
ListingRun::Number ListingRun::chosenValue(const QString &expression) const
{
    const QString condition = QStringLiteral(" if "), otherwise = QStringLiteral(", else ");
    if (!expression.contains(condition))
        return valueOf(expression);
    const QString rest = expression.section(condition, 1);
    return valueOf(holds(rest.section(otherwise, 0, 0)) ? expression.section(condition, 0, 0)
                                                        : rest.section(otherwise, 1));
}

/// All values are read before the first is written.
void ListingRun::assign(const QString &statement)
{
    const QStringList names = statement.section(assigns, 0, 0).split(QStringLiteral(", "));
    const QString right = statement.section(assigns, 1);
    const QStringList expressions
        = names.size() == 1 ? QStringList(right) : right.split(QStringLiteral(", "));
    if (names.size() != expressions.size())
        throw ListingFault(QStringLiteral("unequal sides: ") + statement);
    std::vector<Number> values;
    for (const QString &expression : expressions)
        values.push_back(chosenValue(expression));
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

void ListingRun::draw(const QString &place)
{
    const auto byte = [this](const char *channel) {
        const Number level = valueOf(QString::fromLatin1(channel)) + Number(1, 2);
        // Rounds towards 0, which is down for levels that are not negative.
        const BigInteger whole = numerator(level) / denominator(level);
        return std::clamp(whole.convert_to<int>(), 0, 255);
    };
    const auto coordinate = [&](int part) {
        const Number value = valueOf(place.section(QStringLiteral(", "), part, part));
        if (denominator(value) != 1)
            throw ListingFault(QStringLiteral("is no pixel: ") + place);
        return numerator(value).convert_to<std::int64_t>();
    };
    std::int64_t x = coordinate(0), y = coordinate(1);
    if (m_exchange == Exchange::Axes)
        std::swap(x, y);
    if (x >= m_box.firstX && x < m_box.endX && y >= m_box.firstY && y < m_box.endY)
        m_pixels[{x, y}] = qRgb(byte("R"), byte("G"), byte("B"));
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
