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
    auto statements = m_spelledOut.find(text);
    if (statements == m_spelledOut.end())
        statements = m_spelledOut.emplace(text, spelledOut(text)).first;
    for (const QString &statement : statements->second)
        runStatement(statement);
}

void ListingState::runStatement(const QString &text)
{
    if (text.startsWith(u"pixel ("_s) || text.startsWith(u"frame["_s))
        draw(text);
    else if (text.startsWith(u"L_ij ← L"_s))
        m_edge = chosen(text.section(assigns, 1)).sliced(1);
    else if (text.startsWith(u"add "_s))
        add(text);
    else if (text == u"exchange x and y, here and where a pixel is written"_s)
        exchangeAxes();
    else if (text == u"exchange i and j"_s)
        std::swap(m_edge[0], m_edge[1]);
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
    const QStringList expressions = names.size() == 1 ? QStringList(right) : right.split(u", "_s);
    if (names.size() != expressions.size())
        throw ListingFault(u"unequal sides: "_s + statement);
    std::vector<Result> results;
    for (const QString &expression : expressions)
        results.push_back(resultOf(chosen(expression)));
    for (qsizetype i = 0; i < names.size(); ++i)
        set(names[i], results[std::size_t(i)]);
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

void ListingState::draw(const QString &statement)
{
    static const QRegularExpression pixel(
        u"^(?:pixel \\((.+)\\)|frame\\[(.+)\\]) ← (?:the bytes of (.+), (.+), (.+)|colour)$"_s);
    const auto match = pixel.match(statement);
    if (!match.hasMatch())
        throw ListingFault(u"draws nothing: "_s + statement);
    const auto byte = [&](int part, const char *channel) {
        const QString named = match.captured(part);
        const Number level
            = valueOf(named.isEmpty() ? u"colour "_s + QLatin1String(channel) : named);
        const ListingNames levels = {{u"R"_s, level}};
        const Number nearest = pixelplumb::valueOf(u"⌊R + ½⌋"_s, levels, m_arithmetic);
        return std::clamp(nearest, Number(0), Number(255)).convert_to<int>();
    };
    const QRgb colour = qRgb(byte(3, "R"), byte(4, "G"), byte(5, "B"));
    const QString address = match.captured(2);
    write(address.isEmpty() ? match.captured(1)
                            : u"x₀ + %1 mod width, y₀ + ⌊%1/width⌋"_s.arg(address),
          colour);
}

/// Writes both pixels of "x ± 1".
void ListingState::write(const QString &place, QRgb colour)
{
    const qsizetype both = place.indexOf(u'±');
    if (both >= 0) {
        for (const QChar sign : {u'+', u'−'})
            write(QString(place).replace(both, 1, sign), colour);
        return;
    }
    const auto coordinate = [&](int part) {
        const Number value = valueOf(place.section(u", "_s, part, part));
        if (denominator(value) != 1)
            throw ListingFault(u"is no pixel: "_s + place);
        return numerator(value).convert_to<std::int64_t>();
    };
    std::int64_t x = coordinate(0), y = coordinate(1);
    if (m_exchange == Exchange::Axes)
        std::swap(x, y);
    if (x >= m_box.firstX && x < m_box.endX && y >= m_box.firstY && y < m_box.endY)
        m_pixels[{x, y}] = colour;
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
    std::array<std::array<Number, 5>, 3> vertices; // in the order x, y, R, G, B
    const QString letters = u"xyRGB"_s;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t letter = 0; letter < 5; ++letter)
            vertices[vertex][letter]
                = names.at(letters[qsizetype(letter)] + QString(QChar(u'₀' + int(vertex))));
    const auto before = [isByY](const auto &a, const auto &b) {
        return isByY ? std::tuple(b[1], a[0]) < std::tuple(a[1], b[0])
                     : std::tuple(a[0], a[1]) < std::tuple(b[0], b[1]);
    };
    std::ranges::stable_sort(vertices, before);
    const std::size_t sorted = statement.contains(u"in the order given"_s) ? 2 : 5;
    const QStringList points = statement.section(u": "_s, 1).section(u';', 0, 0).split(u", "_s);
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t letter = 0; letter < sorted; ++letter)
            names[letters[qsizetype(letter)] + points[qsizetype(vertex)].sliced(1)]
                = vertices[vertex][letter];
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
    if (!text.contains(u'_') || text.startsWith(u"L_ij"_s))
        return text;
    static const QRegularExpression indexed(u"(?<=[a-z])\\[([a-z])\\]"_s);
    for (auto match = indexed.match(text); match.hasMatch(); match = indexed.match(text))
        text.replace(match.capturedStart(1), 1,
                     QString::fromStdString(valueOf(match.captured(1)).str()));
    if (!m_edge.isEmpty())
        text.replace(both, m_edge)
            .replace(first, m_edge.chopped(1))
            .replace(second, m_edge.startsWith(u'_') ? u'_' + m_edge.last(1) : m_edge.last(1));
    return m_index.isEmpty() ? text : text.replace(index, u'_' + m_index);
}

} // namespace pixelplumb
