// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listingstate.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <tuple>

namespace pixelplumb {

void ListingState::run(const QString &text)
{
    if (text.startsWith(u"sort the vertices "_s)) {
        sortVertices(text, m_names);
        if (m_keepsExact)
            sortVertices(text, m_exact);
        return;
    }
    static const QRegularExpression ofCarried(
        u"^for each carried value v(?: but ([^:]+))?: (.+)$"_s),
        value(u"(?<![A-Za-z])v(?![A-Za-z])"_s);
    if (text.startsWith(u"given: "_s))
        return;
    if (text.startsWith(u"carry "_s)) {
        m_carried += text.sliced(6).split(u", "_s);
        return;
    }
    if (const auto match = ofCarried.match(text); match.hasMatch()) {
        const QStringList left = match.captured(1).split(u" and "_s);
        for (const QString &carried : QStringList(m_carried)) {
            if (!left.contains(carried))
                run(match.captured(2).replace(value, carried));
        }
        return;
    }
    auto statements = m_spelledOut.find(text);
    if (statements == m_spelledOut.end())
        statements = m_spelledOut.emplace(text, spelledOut(text, m_carried)).first;
    for (const QString &statement : statements->second)
        runStatement(statement);
}

void ListingState::runStatement(const QString &statement)
{
    static const QRegularExpression ofEdge(u"^(?:E|f_)\\w+: "_s,
                                           QRegularExpression::UseUnicodePropertiesOption);
    const QString text
        = statement.contains(u": "_s) ? QString(statement).remove(ofEdge) : statement;
    if (text.startsWith(u"pixel ("_s) || text.startsWith(u"frame["_s))
        draw(text);
    else if (text.startsWith(u"L_ij ← L"_s))
        m_edge = chosen(text.section(assigns, 1)).sliced(1);
    else if (text.startsWith(u"add "_s))
        add(text);
    else if (text == u"exchange x and y, here and where a pixel is written"_s)
        exchangeAxes();
    else if (text == u"exchange the ends"_s)
        exchangeEnds();
    else if (text == u"exchange i and j"_s)
        std::swap(m_edge[0], m_edge[1]);
    else if (text.startsWith(u"on to the next "_s) || text == u"done"_s)
        m_leaves = true;
    else if (text.contains(assigns))
        assign(text);
    else
        throw ListingFault(u"does nothing: "_s + text);
}

/// Of "1 if y₁ ≥ y₀, else −1", which is never part of an expression, the side that holds.
QString ListingState::chosen(const QString &expression) const
{
    const QString condition = u" if "_s, otherwise = u", else "_s;
    if (!expression.contains(condition))
        return expression;
    const QString rest = expression.section(condition, 1);
    return holds(rest.section(otherwise, 0, 0)) ? expression.section(condition, 0, 0)
                                                : chosen(rest.section(otherwise, 1));
}

/// All values are read before the first is written.
void ListingState::assign(const QString &statement)
{
    const QStringList names = statement.section(assigns, 0, 0).split(u", "_s);
    const QString right = chosen(statement.section(assigns, 1));
    const std::vector<Result> results
        = names.size() == 1 && !isCall(right) ? std::vector{resultOf(right)} : resultsOf(right);
    if (names.size() != qsizetype(results.size()))
        throw ListingFault(u"unequal sides: "_s + statement);
    for (qsizetype i = 0; i < names.size(); ++i)
        set(names[i], results[std::size_t(i)]);
}

/// The values of "A, B"; of "the bytes of A, B", "pixel (x, y)" and a given function's call.
std::vector<ListingState::Result> ListingState::resultsOf(const QString &right) const
{
    static const QRegularExpression ofCall(u"^(\\w+)\\((.+)\\)$"_s),
        ofBytes(u"^the bytes? of (.+)$"_s), ofPixel(u"^pixel \\((.+)\\)$"_s);
    std::vector<Result> results;
    const auto append = [&results](const Number &value) { results.push_back({value, value}); };
    if (const auto pixel = ofPixel.match(right); pixel.hasMatch()) {
        const QRgb colour = pixelAt(pixel.captured(1));
        for (const int byte : {qRed(colour), qGreen(colour), qBlue(colour)})
            append(byte);
        return results;
    }
    if (const auto bytes = ofBytes.match(right); bytes.hasMatch()) {
        for (const QString &level : bytes.captured(1).split(u", "_s))
            append(byteOf(level));
        return results;
    }
    if (const auto call = ofCall.match(right); call.hasMatch() && isCall(right)) {
        std::vector<Number> arguments;
        for (const QString &argument : call.captured(2).split(u", "_s))
            arguments.push_back(valueOf(argument));
        for (const Number &value : m_given.at(call.captured(1))(arguments))
            append(value);
        return results;
    }
    for (const QString &expression : listed(right))
        results.push_back(resultOf(chosen(expression)));
    return results;
}

bool ListingState::isCall(const QString &right) const
{
    return right.startsWith(u"the byte"_s) || right.startsWith(u"pixel ("_s)
        || (right.endsWith(u')') && m_given.contains(right.section(u'(', 0, 0)));
}

void ListingState::add(const QString &statement)
{
    const QString to = u" to "_s;
    const QStringList changes = statement.sliced(4).section(to, 0, 0).split(u", "_s);
    const QStringList names = statement.section(to, 1).split(u", "_s);
    if (names.size() != changes.size())
        throw ListingFault(u"unequal sides: "_s + statement);
    for (qsizetype i = 0; i < names.size(); ++i) {
        const QString sum = names[i] + u" + "_s + changes[i];
        set(names[i], resultOf(sum));
    }
}

/// An exact value that does not exist, since it would divide by 0, is that which is computed.
ListingState::Result ListingState::resultOf(const QString &expression) const
{
    const Number computed = pixelplumb::valueOf(expression, m_names, m_arithmetic);
    if (!m_keepsExact)
        return {computed, {}};
    try {
        return {computed, pixelplumb::valueOf(expression, m_exact, Arithmetic::Exact)};
    } catch (const ListingFault &) {
        return {computed, computed};
    }
}

void ListingState::set(const QString &name, const Result &result)
{
    m_names[name] = result.computed;
    if (m_keepsExact)
        m_exact[name] = result.exact;
}

/// Of the two ends of an edge, and of each pixel from here on.
void ListingState::exchangeAxes()
{
    for (ListingNames *names : {&m_names, &m_exact}) {
        if (names == &m_exact && !m_keepsExact)
            continue;
        std::swap(names->at(u"x₀"_s), names->at(u"y₀"_s));
        std::swap(names->at(u"x₁"_s), names->at(u"y₁"_s));
    }
    m_exchange = Exchange::Axes;
}

void ListingState::exchangeEnds()
{
    for (ListingNames *names : {&m_names, &m_exact})
        for (auto &[name, value] : *names) {
            const auto other = names->find(name.chopped(1) + u'₁');
            if (name.endsWith(u'₀') && other != names->end())
                std::swap(value, other->second);
        }
}

bool ListingState::holds(const QString &condition) const
{
    return m_keepsExact && m_asked == Asked::Exact
        ? pixelplumb::holds(condition, m_exact, Arithmetic::Exact)
        : pixelplumb::holds(condition, m_names, m_arithmetic);
}

ListingState::Number ListingState::valueOf(const QString &expression) const
{
    return m_keepsExact && m_asked == Asked::Exact
        ? pixelplumb::valueOf(chosen(expression), m_exact, Arithmetic::Exact)
        : pixelplumb::valueOf(chosen(expression), m_names, m_arithmetic);
}

std::pair<std::int64_t, std::int64_t> ListingState::frameAlong(const QString &coordinate) const
{
    const bool isY = (coordinate == u"y"_s) != (m_exchange == Exchange::Axes);
    return isY ? std::pair(m_box.firstY, m_box.endY - 1) : std::pair(m_box.firstX, m_box.endX - 1);
}

/// Vertices of equal x are ordered by y, those of equal y by x. The names that they get may be new.
void ListingState::sortVertices(const QString &statement, ListingNames &names)
{
    const bool isByY = statement.startsWith(u"sort the vertices by y"_s);
    QStringList values = {u"x"_s, u"y"_s}; // that the vertices have
    for (const auto &[name, value] : names) {
        if (name.endsWith(u'₀') && names.contains(name.chopped(1) + u'₂') && name != u"x₀"
            && name != u"y₀" && !name.contains(u'P'))
            values.append(name.chopped(1));
    }
    std::array<std::vector<Number>, 3> vertices;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (const QString &value : values)
            vertices[vertex].push_back(names.at(value + QChar(u'₀' + int(vertex))));
    const auto before = [isByY](const auto &a, const auto &b) {
        return isByY ? std::tuple(b[1], a[0]) < std::tuple(a[1], b[0])
                     : std::tuple(a[0], a[1]) < std::tuple(b[0], b[1]);
    };
    std::ranges::stable_sort(vertices, before);
    if (statement.contains(u"in the order given"_s))
        values.resize(2);
    const QStringList points = statement.section(u": "_s, 1).section(u';', 0, 0).split(u", "_s);
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (qsizetype value = 0; value < values.size(); ++value)
            names[values[value] + points[qsizetype(vertex)].sliced(1)]
                = vertices[vertex][std::size_t(value)];
}

std::vector<ListingState::Number> ListingState::indicesOf(const QString &name) const
{
    const QString begin = name + u'[';
    std::vector<Number> indices;
    for (auto entry = m_names.lower_bound(begin);
         entry != m_names.end() && entry->first.startsWith(begin); ++entry)
        indices.emplace_back(entry->first.sliced(begin.size()).chopped(1).toStdString());
    std::ranges::sort(indices);
    return indices;
}

QString ListingState::meant(QString text) const
{
    static const QRegularExpression both(u"_ij\\b"_s), first(u"_i\\b"_s), second(u"_j\\b"_s),
        index(u"_k\\b"_s);
    static const QRegularExpression indexed(u"(?<=[A-Za-z])\\[([a-z](?:, [a-z])*)\\]"_s);
    if (!(text.contains(u'_') || text.contains(u'[')) || text.startsWith(u"L_ij"_s))
        return text;
    for (auto match = indexed.match(text); match.hasMatch(); match = indexed.match(text)) {
        QStringList indices;
        for (const QString &each : match.captured(1).split(u", "_s))
            indices.append(QString::fromStdString(valueOf(each).str()));
        text.replace(match.capturedStart(1), match.capturedLength(1), indices.join(u','));
    }
    if (!m_edge.isEmpty())
        text.replace(both, m_edge)
            .replace(first, m_edge.chopped(1))
            .replace(second, m_edge.startsWith(u'_') ? u'_' + m_edge.last(1) : m_edge.last(1));
    return m_index.isEmpty() ? text : text.replace(index, u'_' + m_index);
}

} // namespace pixelplumb
