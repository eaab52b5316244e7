// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/edgelinenumbers.h"

#include "core/oracle/oracle.h"

namespace pixelplumb {

namespace {

/// The ids of a family's edges, and the vertex at which each begins.
struct EdgeIds {
    std::array<const char *, 3> ends; ///< of "a_0"
    std::array<std::size_t, 3> from;
    char16_t letter; ///< of the function's name
};

constexpr EdgeIds edgeEquationIds = {{"_0", "_1", "_2"}, {0, 1, 2}, u'E'};
constexpr EdgeIds barycentricIds = {{"_bc", "_ca", "_ab"}, {1, 2, 0}, u'f'};

std::optional<EdgeLines> kernelLines(const LayerMoment &moment, const EdgeIds &ids)
{
    const SetUpRecord setUp = moment.trace().setUp(moment.primitive);
    const auto &descriptions = moment.trace().numbers().setUp;
    const NamedNumbers numbers(descriptions, setUp.cells);
    const auto &vertices = moment.triangle().vertices;
    EdgeLines edges;
    for (std::size_t line = 0; line < 3; ++line) {
        const QString end = QString::fromLatin1(ids.ends[line]);
        const QString id = u'a' + end;
        const auto described = std::ranges::find(descriptions, id, &NumberDescription::id);
        edges.lines[line] = {{},
                             numbers[id],
                             numbers[u'b' + end],
                             placeOf(vertices[ids.from[line]].position),
                             placeOf(vertices[(ids.from[line] + 1) % 3].position)};
        if (edges.lines[line].a.isNone() || edges.lines[line].b.isNone())
            return std::nullopt;
        edges.lines[line].name = QChar(ids.letter) + described->title.sliced(1);
    }
    return edges;
}

/// The oracle judges samples; its edge functions change by A and B from one sample to the next.
EdgeLines exactLines(const LayerMoment &moment)
{
    const Triangle &triangle = moment.triangle();
    const BoundaryRule rule = boundaryRuleOf(moment.view.traced->scene);
    const std::int64_t x = floorPixel(triangle.vertices[0].position.x);
    const std::int64_t y = floorPixel(triangle.vertices[0].position.y);
    const auto here = oracle::judge(triangle, rule, x, y).edges;
    const auto right = oracle::judge(triangle, rule, x + 1, y).edges;
    const auto above = oracle::judge(triangle, rule, x, y + 1).edges;
    constexpr Int128 squarePixel = Int128(unitsPerPixel) * unitsPerPixel;
    EdgeLines edges;
    edges.origin = NumberOrigin::Exact;
    for (std::size_t line = 0; line < 3; ++line) {
        const auto gained = [&](const oracle::EdgeVerdict &next) {
            return Quantity::rational(next.edgeFunction - here[line].edgeFunction, squarePixel);
        };
        const auto vertexAt
            = [&](int vertex) { return placeOf(triangle.vertices[std::size_t(vertex)].position); };
        edges.lines[line]
            = {u"E"_s + QChar(char16_t(u'₀' + line)), gained(right[line]), gained(above[line]),
               vertexAt(here[line].from), vertexAt(here[line].to)};
    }
    return edges;
}

} // namespace

EdgeLines edgeLinesOf(const LayerMoment &moment)
{
    if (const auto edges = kernelLines(moment, edgeEquationIds))
        return *edges;
    if (const auto edges = kernelLines(moment, barycentricIds))
        return *edges;
    return exactLines(moment);
}

} // namespace pixelplumb
