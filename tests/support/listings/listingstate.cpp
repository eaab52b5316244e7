// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listingstate.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <tuple>

namespace pixelplumb {

void ListingState::run(const QString &text)
{
    if (text.startsWith(QStringLiteral("sort the vertices "))) {
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
    if (text.startsWith(QStringLiteral("pixel (")) || text.startsWith(QStringLiteral("frame[")))
        draw(text);
    else if (text.startsWith(QStringLiteral("L_ij ← L")))
        m_edge = chosen(text.section(assigns, 1)).sliced(1);
    else if (text.startsWith(QStringLiteral("add ")))
        add(text);
    else if (text == QStringLiteral("exchange x and y, here and where a pixel is written"))
        exchangeAxes();
    else if (text == QStringLiteral("exchange i and j"))
        std::swap(m_edge[0], m_edge[1]);
    else if (text.contains(assigns))
        assign(text);
    else
        throw ListingFault(QStringLiteral("does nothing: ") + text);
}

/// Of "1 if y₁ ≥ y₀, else −1", which is never part of an expression, the side that holds.
QString ListingState::chosen(const QString &expression) const
{
    const QString condition = QStringLiteral(" if "), otherwise = QStringLiteral(", else ");
    if (!expression.contains(condition))
        return expression;
    const QString rest = expression.section(condition, 1);
    return holds(rest.section(otherwise, 0, 0)) ? expression.section(condition, 0, 0)
                                                : chosen(rest.section(otherwise, 1));
}

/// All values are read before the first is written.
void ListingState::assign(const QString &statement)
{
    const QStringList names = statement.section(assigns, 0, 0).split(QStringLiteral(", "));
    const QString right = chosen(statement.section(assigns, 1));
    const QStringList expressions
        = names.size() == 1 ? QStringList(right) : right.split(QStringLiteral(", "));
    if (names.size() != expressions.size())
        throw ListingFault(QStringLiteral("unequal sides: ") + statement);
    std::vector<Result> results;
    for (const QString &expression : expressions)
        results.push_back(resultOf(chosen(expression)));
    for (qsizetype i = 0; i < names.size(); ++i)
        set(names[i], results[std::size_t(i)]);
}

void ListingState::add(const QString &statement)
{
    const QString to = QStringLiteral(" to ");
    const QStringList changes = statement.sliced(4).section(to, 0, 0).split(QStringLiteral(", "));
    const QStringList names = statement.section(to, 1).split(QStringLiteral(", "));
    if (names.size() != changes.size())
        throw ListingFault(QStringLiteral("unequal sides: ") + statement);
    for (qsizetype i = 0; i < names.size(); ++i) {
        const QString sum = names[i] + QStringLiteral(" + ") + changes[i];
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
        std::swap(names->at(QStringLiteral("x₀")), names->at(QStringLiteral("y₀")));
        std::swap(names->at(QStringLiteral("x₁")), names->at(QStringLiteral("y₁")));
    }
    m_exchange = Exchange::Axes;
}

void ListingState::draw(const QString &statement)
{
    static const QRegularExpression pixel(QStringLiteral(
        "^(?:pixel \\((.+)\\)|frame\\[(.+)\\]) ← (?:the bytes of (.+), (.+), (.+)|colour)$"));
    const auto match = pixel.match(statement);
    if (!match.hasMatch())
        throw ListingFault(QStringLiteral("draws nothing: ") + statement);
    const auto byte = [&](int part, const char *channel) {
        const QString named = match.captured(part);
        const Number level
            = valueOf(named.isEmpty() ? QStringLiteral("colour ") + QLatin1String(channel) : named);
        const ListingNames levels = {{QStringLiteral("R"), level}};
        const Number nearest = pixelplumb::valueOf(QStringLiteral("⌊R + ½⌋"), levels, m_arithmetic);
        return std::clamp(nearest, Number(0), Number(255)).convert_to<int>();
    };
    const QRgb colour = qRgb(byte(3, "R"), byte(4, "G"), byte(5, "B"));
    const QString address = match.captured(2);
    write(address.isEmpty() ? match.captured(1)
                            : QStringLiteral("x₀ + %1 mod width, y₀ + ⌊%1/width⌋").arg(address),
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
        const Number value = valueOf(place.section(QStringLiteral(", "), part, part));
        if (denominator(value) != 1)
            throw ListingFault(QStringLiteral("is no pixel: ") + place);
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
    const bool isY = (coordinate == QStringLiteral("y")) != (m_exchange == Exchange::Axes);
    return isY ? std::pair(m_box.firstY, m_box.endY - 1) : std::pair(m_box.firstX, m_box.endX - 1);
}

/// Vertices of equal x are ordered by y, those of equal y by x. The names that they get may be new.
void ListingState::sortVertices(const QString &statement, ListingNames &names)
{
    const bool isByY = statement.startsWith(QStringLiteral("sort the vertices by y"));
    std::array<std::array<Number, 5>, 3> vertices; // in the order x, y, R, G, B
    const QString letters = QStringLiteral("xyRGB");
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (std::size_t letter = 0; letter < 5; ++letter)
            vertices[vertex][letter]
                = names.at(letters[qsizetype(letter)] + QString(QChar(u'₀' + int(vertex))));
    const auto before = [isByY](const auto &a, const auto &b) {
        return isByY ? std::tuple(b[1], a[0]) < std::tuple(a[1], b[0])
                     : std::tuple(a[0], a[1]) < std::tuple(b[0], b[1]);
    };
    std::ranges::stable_sort(vertices, before);
    const std::size_t sorted = statement.contains(QStringLiteral("in the order given")) ? 2 : 5;
    const QStringList points = statement.section(QStringLiteral(": "), 1)
                                   .section(u';', 0, 0)
                                   .split(QStringLiteral(", "));
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
    static const QRegularExpression both(QStringLiteral("_ij\\b")), first(QStringLiteral("_i\\b")),
        second(QStringLiteral("_j\\b")), index(QStringLiteral("_k\\b"));
    if (!text.contains(u'_') || text.startsWith(QStringLiteral("L_ij")))
        return text;
    static const QRegularExpression indexed(QStringLiteral("(?<=[a-z])\\[([a-z])\\]"));
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
