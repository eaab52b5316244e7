// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layers.h"
#include "core/polygons/triangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pixelplumb {

namespace {

const QString fanMethod = QStringLiteral("polygon-fan");
const QString delaunayMethod = QStringLiteral("polygon-delaunay");
const QString tessellationMethod = QStringLiteral("polygon-tessellation");

using Piece = std::array<LatticePoint, 3>;

/// Through the three corners; of radius 0 where they lie on a line.
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

/// Each edge once: solid where two triangles share it, dotted where it bounds the polygon.
void appendEdges(const std::vector<Piece> &pieces, LayerDrawing &drawing)
{
    std::map<std::pair<LatticePoint, LatticePoint>, int> sides;
    for (const Piece &piece : pieces) {
        for (std::size_t i = 0; i < 3; ++i)
            ++sides[std::minmax(piece[i], piece[(i + 1) % 3])];
    }
    for (const auto &[edge, count] : sides) {
        const bool isInner = count > 1;
        drawing.lines.push_back(
            {placeOf(edge.first), placeOf(edge.second), isInner ? LayerInk::First : LayerInk::Mark,
             isInner ? LayerDrawing::Stroke::Solid : LayerDrawing::Stroke::Dotted});
    }
}

void appendPieceInHand(const LayerMoment &moment, const std::vector<Piece> &pieces,
                       LayerDrawing &drawing)
{
    const std::optional<std::size_t> span = moment.spanInHand();
    if (!span)
        return;
    const auto piece = std::size_t(moment.trace().placeOf(*span).part);
    if (piece < pieces.size())
        drawing.areas.push_back(
            {{placeOf(pieces[piece][0]), placeOf(pieces[piece][1]), placeOf(pieces[piece][2])},
             LayerInk::Hand});
}

void drawInnerEdges(const LayerMoment &moment, LayerDrawing &drawing)
{
    const QString &method = moment.view.traced->method->id;
    const bool isFan = method == fanMethod;
    const auto triangulate = isFan ? fanOf : method == delaunayMethod ? delaunayOf : tessellationOf;
    const std::vector<Piece> pieces = triangulate(contoursOf(moment.shape())).triangles;
    appendEdges(pieces, drawing);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!isFan && doubledArea(pieces[i][0], pieces[i][1], pieces[i][2]) != 0)
            drawing.circles.push_back(circumcircleOf(pieces[i]));
        const QPointF centroid
            = (placeOf(pieces[i][0]) + placeOf(pieces[i][1]) + placeOf(pieces[i][2])) / 3;
        drawing.labels.push_back({QString::number(i), centroid, LayerInk::First});
    }
    appendPieceInHand(moment, pieces, drawing);
}

} // namespace

Layer innerEdgesLayer()
{
    return {.id = QStringLiteral("inner-edges"),
            .title = QStringLiteral("Triangles of a polygon"),
            .toolTip = QStringLiteral(
                "The inner edges of the fan or the triangulation that the method fills, its "
                "triangles by number, the one in hand tinted, and of a Delaunay triangulation the "
                "circles around them, which no vertex that they see lies in."),
            .source = QStringLiteral("Rasterization slides, “Triangulation”; Scan Conversion "
                                     "slides, “From Polygons to Triangles”"),
            .kinds = {PrimitiveKind::Polygon},
            .methods = {fanMethod, delaunayMethod, tessellationMethod},
            .draw = drawInnerEdges};
}

} // namespace pixelplumb
