// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listingrun.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <tuple>

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

void ListingRun::runSetUp(std::size_t end)
{
    for (std::size_t line = 0; line < end; ++line) {
        const QString text = withoutRemark(m_code[line].text);
        if (m_setUp == SetUp::Run) {
            if (!text.startsWith(QStringLiteral("if no sample")))
                runLine(line);
            continue;
        }
        const QString name = text.section(assigns, 0, 0);
        if (text.contains(QStringLiteral(", else ")) && !name.contains(u' ')
            && !m_names.contains(name))
            runStatement(text);
    }
}

/// Vertices of equal x are ordered by y, those of equal y by x.
void ListingRun::sortVertices(const QString &text)
{
    const bool isByY = text.contains(QStringLiteral("by y"));
    std::array<std::array<Number, 5>, 3> vertices; // in the order x, y, R, G, B
    const QString letters = QStringLiteral("xyRGB");
    const auto named = [&](std::size_t vertex, std::size_t letter) {
        return QString(letters[qsizetype(letter)]) + QChar(u'₀' + int(vertex));
    };
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t letter = 0; letter < 5; ++letter)
            vertices[vertex][letter] = m_names.at(named(vertex, letter));
    const auto before = [isByY](const auto &a, const auto &b) {
        return isByY ? std::tuple(b[1], a[0]) < std::tuple(a[1], b[0])
                     : std::tuple(a[0], a[1]) < std::tuple(b[0], b[1]);
    };
    std::ranges::stable_sort(vertices, before);
    const std::size_t sorted = text.contains(QStringLiteral("in the order given")) ? 2 : 5;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t letter = 0; letter < sorted; ++letter)
            m_names[named(vertex, letter)] = vertices[vertex][letter];
}

/// False if the line is not of each edge.
bool ListingRun::runEdges(const QString &text)
{
    static const QRegularExpression ofEdges(
        QStringLiteral("^for each edge L_ij of ([^:]+): (.+)$"));
    if (!text.startsWith(QStringLiteral("for each edge L_ij")))
        return false;
    const auto match = ofEdges.match(text);
    for (const QString &edge : match.captured(1).split(QStringLiteral(", "))) {
        m_edge = edge.sliced(1);
        runStatements(ofEdge(match.captured(2)));
    }
    m_edge.clear();
    return true;
}

/// The text with the digits of the current edge.
QString ListingRun::ofEdge(QString text) const
{
    static const QRegularExpression both(QStringLiteral("_ij\\b")), first(QStringLiteral("_i\\b")),
        second(QStringLiteral("_j\\b"));
    if (m_edge.isEmpty() || text.startsWith(QStringLiteral("L_ij"))
        || !text.contains(QStringLiteral("_")))
        return text;
    return text.replace(both, m_edge).replace(first, m_edge.left(1)).replace(second, m_edge.mid(1));
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
    const QString printed = withoutRemark(m_code[line].text);
    if (runEdges(printed))
        return;
    const QString text = ofEdge(printed);
    if (text.startsWith(QStringLiteral("sort the vertices ")))
        sortVertices(text);
    else if (!runLoop(line, text) && !runCase(line, text))
        runStatements(text);
}

/// False if the line is no loop.
bool ListingRun::runLoop(std::size_t line, const QString &text)
{
    static const QRegularExpression ofBox(QStringLiteral("^for each (x|y) of the box:$"));
    static const QRegularExpression ofRange(
        QStringLiteral("^for each (?:\\w+ )?(\\S+)(?: = i/(\\S+))? from (.+?)( down)? to (.+):$"),
        QRegularExpression::UseUnicodePropertiesOption);
    if (!text.startsWith(QStringLiteral("for each ")))
        return false;
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
    const bool isDown = !match.captured(4).isEmpty();
    const Number last = valueOf(chosen(match.captured(5)));
    const bool wasFirst = m_isFirst;
    m_isFirst = true;
    for (Number at = valueOf(match.captured(3)); isDown ? at >= last : at <= last;
         at += isDown ? Number(-step) : step) {
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
    const QString first = QStringLiteral("the first:"),
                  begins = QStringLiteral("where it begins: "), otherwise = QStringLiteral("else:"),
                  ifElse = QStringLiteral("else if "), onlyIf = QStringLiteral("if ");
    bool isTaken = false;
    if (text.startsWith(first))
        isTaken = m_isFirst;
    else if (text.startsWith(begins))
        isTaken = !m_names.contains(text.sliced(begins.size()).section(assigns, 0, 0));
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
    auto statements = m_spelledOut.find(text);
    if (statements == m_spelledOut.end())
        statements = m_spelledOut.emplace(text, spelledOut(text)).first;
    for (const QString &statement : statements->second)
        runStatement(statement);
}

void ListingRun::runStatement(const QString &text)
{
    if (text.startsWith(QStringLiteral("pixel (")))
        draw(text);
    else if (text.startsWith(QStringLiteral("L_ij ← L")))
        m_edge = chosen(text.section(assigns, 1)).sliced(1);
    else if (text.startsWith(QStringLiteral("add ")))
        add(text);
    else if (text.contains(assigns))
        assign(text);
    else
        throw ListingFault(QStringLiteral("does nothing: ") + text);
}

/// Of "1 if y₁ ≥ y₀, else −1", which is never part of an expression, the side that holds.
QString ListingRun::chosen(const QString &expression) const
{
    const QString condition = QStringLiteral(" if "), otherwise = QStringLiteral(", else ");
    if (!expression.contains(condition))
        return expression;
    const QString rest = expression.section(condition, 1);
    return holds(rest.section(otherwise, 0, 0)) ? expression.section(condition, 0, 0)
                                                : chosen(rest.section(otherwise, 1));
}

/// All values are read before the first is written.
void ListingRun::assign(const QString &statement)
{
    const QStringList names = statement.section(assigns, 0, 0).split(QStringLiteral(", "));
    const QString right = chosen(statement.section(assigns, 1));
    const QStringList expressions
        = names.size() == 1 ? QStringList(right) : right.split(QStringLiteral(", "));
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

void ListingRun::draw(const QString &statement)
{
    static const QRegularExpression pixel(
        QStringLiteral("^pixel \\((.+)\\) ← (?:the bytes of (.+), (.+), (.+)|colour)$"));
    const auto match = pixel.match(statement);
    if (!match.hasMatch())
        throw ListingFault(QStringLiteral("draws nothing: ") + statement);
    const auto byte = [&](int part, const char *channel) {
        const QString named = match.captured(part);
        const Number level = valueOf(named.isEmpty() ? QString::fromLatin1(channel) : named);
        // Rounds towards 0, which is down for levels that are not negative.
        const Number half = std::clamp(level, Number(0), Number(255)) + Number(1, 2);
        return BigInteger(numerator(half) / denominator(half)).convert_to<int>();
    };
    const QString place = match.captured(1);
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
        m_pixels[{x, y}] = qRgb(byte(2, "R"), byte(3, "G"), byte(4, "B"));
}

bool ListingRun::holds(const QString &condition) const
{
    return pixelplumb::holds(condition, m_names);
}

ListingRun::Number ListingRun::valueOf(const QString &expression) const
{
    return pixelplumb::valueOf(expression, m_names);
}

} // namespace pixelplumb
