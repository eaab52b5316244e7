// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layers.h"
#include "core/methods/polygons/polygonkernels.h"
#include "core/methods/words/formulatext.h"

#include <cmath>

namespace pixelplumb {

namespace {

constexpr std::size_t mostNamedEdges = 24; ///< more names would hide what they name
constexpr double leaderLength = 20; ///< logical px, from an edge to its name

/// A place where the current row meets an edge.
struct ShownCrossing {
    double x = 0; ///< px
    std::size_t edge = 0; ///< its index in the contours
};

/// The crossings in the row's table, ascending in x.
std::vector<ShownCrossing> crossingsIn(const NamedNumbers &row)
{
    std::vector<ShownCrossing> crossings;
    for (int i = 0;; ++i) {
        const Quantity x = row[u"x_%1"_s.arg(i)];
        const Quantity edge = row[u"edge_%1"_s.arg(i)];
        if (x.isNone() || edge.isNone())
            return crossings;
        crossings.push_back({x.toDouble(), std::size_t(edge.toDouble())});
    }
}

/// The edges that the method scans: a polygon's own, the chords of a filled path, or a text's
/// outlines.
Contours scannedContours(const LayerMoment &moment)
{
    switch (moment.shape().kind) {
    case PrimitiveKind::Bezier:
        return BezierFillKernel::geometryOf(moment.primitives(), moment.primitive);
    case PrimitiveKind::Text:
        return TextKernel::geometryOf(moment.primitives(), moment.primitive)->contours;
    default:
        return ParityKernel::geometryOf(moment.primitives(), moment.primitive);
    }
}

/// The bucket of an edge that is not horizontal: its first row, shown at its lower end.
void appendBucket(const Contours &contours, std::size_t number, const LayerMoment &moment,
                  LayerDrawing &drawing)
{
    const ContourEdge &edge = contours.edges[number];
    const double cell = moment.view.cell;
    const bool isUpward = edge.from.y < edge.to.y;
    const LatticePoint &low = isUpward ? edge.from : edge.to;
    const LatticePoint &high = isUpward ? edge.to : edge.from;
    const Interval rows
        = rowsCrossed(moment.frame().origin); // as the kernel's EdgeTable computes them
    const std::int64_t first = firstSampleFrom(low.y, rows);
    const QString place
        = first < endSampleAt(high.y, rows) ? u"from row %1"_s.arg(first) : u"on no row"_s;
    drawing.points.push_back({placeOf(low), LayerInk::Mark});
    const QPointF middle = (placeOf(low) + placeOf(high)) / 2;
    const QPointF up = placeOf(high) - placeOf(low);
    // To the right, at right angles to the edge: where edges cross, it shows whose name it is.
    const QPointF away
        = QPointF(up.y(), -up.x()) / std::hypot(up.x(), up.y()) * (leaderLength / cell);
    drawing.lines.push_back({middle, middle + away, LayerInk::Mark, LayerDrawing::Stroke::Dotted});
    drawing.labels.push_back(
        {u"edge %1, %2"_s.arg(number).arg(place), middle + away, LayerInk::Mark});
}

/// Appends the buckets of all edges or, if they are too many for names, of the active ones.
void appendBuckets(const Contours &contours, const std::vector<ShownCrossing> &active,
                   const LayerMoment &moment, LayerDrawing &drawing)
{
    const std::size_t count = contours.edges.size();
    if (count <= mostNamedEdges) {
        for (std::size_t i = 0; i < count; ++i) {
            if (contours.edges[i].from.y != contours.edges[i].to.y)
                appendBucket(contours, i, moment, drawing);
        }
        return;
    }
    for (const ShownCrossing &crossing : active)
        appendBucket(contours, crossing.edge, moment, drawing);
    drawing.notes.append(u"Edge table: of %1 edges, the active ones have their names"_s.arg(count));
}

/// The edges that the row crosses and, for inside spans between two crossings, the number that
/// makes them inside.
void appendRow(double y, const std::vector<ShownCrossing> &crossings, const Contours &contours,
               FrameOrigin origin, LayerDrawing &drawing)
{
    const bool isByWinding = contours.fill == ShapeFill::NonZero;
    int winding = 0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const ShownCrossing &crossing = crossings[i];
        drawing.points.push_back({{crossing.x, y}, LayerInk::Hand});
        drawing.labels.push_back(
            {u"x%1"_s.arg(QChar(char16_t(u'₀' + i))), {crossing.x, y}, LayerInk::Hand});
        const ContourEdge &edge = contours.edges[crossing.edge];
        drawing.lines.push_back({placeOf(edge.from), placeOf(edge.to), LayerInk::First});
        winding += windingRightOf(edge, origin);
        const bool isInside = isByWinding ? winding != 0 : i % 2 == 0;
        if (!isInside || i + 1 == crossings.size())
            continue;
        const QPointF end(crossings[i + 1].x, y);
        drawing.lines.push_back(
            {{crossing.x, y}, end, LayerInk::Inside, LayerDrawing::Stroke::Band});
        drawing.labels.push_back(
            {isByWinding ? u"w = %1"_s.arg(term(Quantity::integer(winding))) : u"p = 1"_s,
             (QPointF(crossing.x, y) + end) / 2, LayerInk::Inside});
    }
}

void drawEdgeTable(const LayerMoment &moment, LayerDrawing &drawing)
{
    const Contours contours = scannedContours(moment);
    const std::optional<std::size_t> span = moment.currentSpan();
    if (!span)
        return appendBuckets(contours, {}, moment, drawing);
    const SpanRecord record = moment.trace().span(*span);
    const NamedNumbers row(moment.trace().numbers().span, record.cells);
    const std::vector<ShownCrossing> crossings = crossingsIn(row);
    appendBuckets(contours, crossings, moment, drawing);
    appendRow(double(record.place.coordinate), crossings, contours, moment.frame().origin, drawing);
    const auto active = std::int64_t(row[u"active"_s].toDouble());
    if (active > std::int64_t(crossings.size()))
        drawing.notes.append(
            u"Edge table: the first %1 of %2 active edges"_s.arg(crossings.size()).arg(active));
}

} // namespace

Layer edgeTableLayer()
{
    return {.id = "edge-table",
            .title = QT_TRANSLATE_NOOP("core", "Edge table"),
            .toolTip = "Each edge with the row in whose bucket it stands, the first that it "
                       "crosses; of the current row the active edges, their crossings x₀, x₁, … as "
                       "the method computed them, and the intervals between them that lie inside, "
                       "with their parity p or winding number w.",
            .source = "Scan Conversion slides, “Scan Conversion: A General Algorithm”",
            .kinds = {PrimitiveKind::Polygon, PrimitiveKind::Bezier, PrimitiveKind::Text},
            .methods = {"polygon-parity", "bezier-fill", "text-outlines"},
            .draw = drawEdgeTable};
}

} // namespace pixelplumb
