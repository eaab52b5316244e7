// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layers.h"
#include "core/polygons/triangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pixelplumb {

namespace {

const QString fanMethod = "polygon-fan";
const QString delaunayMethod = "polygon-delaunay";
const QString tessellationMethod = "polygon-tessellation";

using Piece = std::array<LatticePoint, 3>;

/// The circle through the three corners; of radius 0 if they lie on a line.
LayerDrawing::Circle circumcircleOf(const Piece &piece)
{
    const QPointF a = placeOf(piece[0]);
    const QPointF b = placeOf(piece[1]) - a;
    const QPointF c = placeOf(piece[2]) - a;
    const double doubled = 2 * (b.x() * c.y() - b.y() * c.x());
    if (doubled == 0)
        return {};
    const double bb = QPointF::dotProduct(b, b);
    const double cc = QPointF::dotProduct(c, c);
    const QPointF centre((c.y() * bb - b.y() * cc) / doubled, (b.x() * cc - c.x() * bb) / doubled);
    return {a + centre, std::hypot(centre.x(), centre.y()), LayerInk::Second};
}

/// Appends each edge of the first `shown` triangles once: solid if two triangles share it, dotted
/// if it bounds the polygon.
void appendEdges(const std::vector<Piece> &pieces, std::size_t shown, LayerDrawing &drawing)
{
    struct Side {
        int count = 0; ///< of its triangles
        bool isShown = false;
    };
    std::map<std::pair<LatticePoint, LatticePoint>, Side> sides;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        for (std::size_t i = 0; i < 3; ++i) {
            Side &side = sides[std::minmax(pieces[piece][i], pieces[piece][(i + 1) % 3])];
            ++side.count;
            side.isShown = side.isShown || piece < shown;
        }
    }
    for (const auto &[edge, side] : sides) {
        if (!side.isShown)
            continue;
        const bool isInner = side.count > 1;
        drawing.lines.push_back(
            {placeOf(edge.first), placeOf(edge.second), isInner ? LayerInk::First : LayerInk::Mark,
             isInner ? LayerDrawing::Stroke::Solid : LayerDrawing::Stroke::Dotted});
    }
}

std::optional<std::size_t> currentPiece(const LayerMoment &moment)
{
    const std::optional<std::size_t> span = moment.currentSpan();
    return span ? std::optional(std::size_t(moment.trace().placeOf(*span).part)) : std::nullopt;
}

void drawInnerEdges(const LayerMoment &moment, LayerDrawing &drawing)
{
    const QString &method = moment.view.traced->method->id;
    const bool isFan = method == fanMethod;
    const auto triangulate = isFan ? fanOf : method == delaunayMethod ? delaunayOf : tessellationOf;
    const std::vector<Piece> pieces = triangulate(contoursOf(moment.shape())).triangles;
    const std::optional<std::size_t> current = currentPiece(moment);
    const std::size_t begun = std::min(current ? *current + 1 : 0, pieces.size());
    const std::size_t shown = moment.hidesSteps() ? begun : pieces.size();
    appendEdges(pieces, shown, drawing);
    for (std::size_t i = 0; i < shown; ++i) {
        if (!isFan && doubledArea(pieces[i][0], pieces[i][1], pieces[i][2]) != 0)
            drawing.circles.push_back(circumcircleOf(pieces[i]));
        const QPointF centroid
            = (placeOf(pieces[i][0]) + placeOf(pieces[i][1]) + placeOf(pieces[i][2])) / 3;
        drawing.labels.push_back({QString::number(i), centroid, LayerInk::First});
    }
    if (current && *current < pieces.size()) {
        const Piece &piece = pieces[*current];
        drawing.areas.push_back(
            {{placeOf(piece[0]), placeOf(piece[1]), placeOf(piece[2])}, LayerInk::Hand});
    }
}

} // namespace

Layer innerEdgesLayer()
{
    return {.id = "inner-edges",
            .title = QT_TRANSLATE_NOOP("core", "Triangles of a polygon"),
            .toolTip
            = "The inner edges of the fan or the triangulation that the method fills, its "
              "triangles by number, the current one tinted, and of a Delaunay triangulation the "
              "circles around them, which no vertex that they see lies in.",
            .source = "Rasterization slides, “Triangulation”; Scan Conversion slides, “From "
                      "Polygons to Triangles”",
            .kinds = {PrimitiveKind::Polygon},
            .methods = {fanMethod, delaunayMethod, tessellationMethod},
            .draw = drawInnerEdges};
}

} // namespace pixelplumb
