// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layers.h"
#include "core/polygons/contours.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// A place where the row in hand meets an edge.
struct ShownCrossing {
    double x = 0; ///< px
    std::size_t edge = 0; ///< its place in the contours
};

/// As many as the table of the row holds, ascending in x.
std::vector<ShownCrossing> crossingsIn(const NamedNumbers &row)
{
    std::vector<ShownCrossing> crossings;
    for (int i = 0;; ++i) {
        const Quantity x = row[QStringLiteral("x_%1").arg(i)];
        const Quantity edge = row[QStringLiteral("edge_%1").arg(i)];
        if (x.isNone() || edge.isNone())
            return crossings;
        crossings.push_back({x.toDouble(), std::size_t(edge.toDouble())});
    }
}

/// The buckets: each edge that rows can cross stands in that of its first row, by its lower end.
void appendBuckets(const Contours &contours, LayerDrawing &drawing)
{
    for (std::size_t i = 0; i < contours.edges.size(); ++i) {
        const ContourEdge &edge = contours.edges[i];
        if (edge.from.y == edge.to.y)
            continue;
        const LatticePoint &lower = edge.from.y < edge.to.y ? edge.from : edge.to;
        drawing.points.push_back({placeOf(lower), LayerInk::Mark});
        drawing.labels.push_back({QStringLiteral("e%1, from row %2").arg(i).arg(ceilPixel(lower.y)),
                                  (placeOf(edge.from) + placeOf(edge.to)) / 2, LayerInk::Mark});
    }
}

/// The edges that the row crosses, and what lies between the first and the second, the third and
/// the fourth crossing.
void appendRow(const NamedNumbers &row, const Contours &contours, ShapeFill fill,
               LayerDrawing &drawing)
{
    const double y = row[QStringLiteral("y")].toDouble();
    const std::vector<ShownCrossing> crossings = crossingsIn(row);
    int winding = 0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const ShownCrossing &crossing = crossings[i];
        drawing.points.push_back({{crossing.x, y}, LayerInk::Hand});
        drawing.labels.push_back({QStringLiteral("x%1").arg(QChar(char16_t(u'₀' + i))),
                                  {crossing.x, y},
                                  LayerInk::Hand});
        if (crossing.edge >= contours.edges.size())
            continue;
        const ContourEdge &edge = contours.edges[crossing.edge];
        drawing.lines.push_back({placeOf(edge.from), placeOf(edge.to), LayerInk::First});
        winding += edge.to.y > edge.from.y ? 1 : -1;
        const bool isInside = fill == ShapeFill::NonZero ? winding != 0 : i % 2 == 0;
        if (isInside && i + 1 < crossings.size())
            drawing.lines.push_back({{crossing.x, y}, {crossings[i + 1].x, y}, LayerInk::Hand});
    }
    const auto active = std::int64_t(row[QStringLiteral("active")].toDouble());
    if (active > std::int64_t(crossings.size()))
        drawing.notes.append(QStringLiteral("Edge table: the first %1 of %2 active edges")
                                 .arg(crossings.size())
                                 .arg(active));
}

void drawEdgeTable(const LayerMoment &moment, LayerDrawing &drawing)
{
    const Contours contours = contoursOf(moment.shape());
    appendBuckets(contours, drawing);
    const std::optional<std::size_t> span = moment.spanInHand();
    if (!span)
        return;
    const SpanRecord record = moment.trace().span(*span);
    appendRow(NamedNumbers(moment.trace().numbers().span, record.cells), contours, contours.fill,
              drawing);
}

} // namespace

Layer edgeTableLayer()
{
    return {.id = QStringLiteral("edge-table"),
            .title = QStringLiteral("Edge table"),
            .toolTip = QStringLiteral(
                "Each edge with the row in whose bucket it stands; of the row in hand the active "
                "edges, their crossings x₀, x₁, … as the method computed them, and the intervals "
                "between them that lie inside."),
            .source
            = QStringLiteral("Scan Conversion slides, “Scan Conversion: A General Algorithm”"),
            .kinds = {PrimitiveKind::Polygon},
            .methods = {QStringLiteral("polygon-parity")},
            .draw = drawEdgeTable};
}

} // namespace pixelplumb
