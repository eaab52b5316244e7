// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/textoutlines.h"
#include "widgets/look/framepainter.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

/// Outlines of the primitives that are not triangles, and the off-screen point.
namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double outlineWidth = 1.5;
constexpr double clippedWidth = 2.5; ///< of the polygon that clipping made
constexpr double offScreenSize = 7; ///< of the off-screen point's mark, from its middle
constexpr double largestCurve = 1e6;
/// Limits for all visible lines of one outline. More would hide the picture and take too long to
/// drag: about 0.2 ms for 700 px of one line, twenty times that for 700 px of one stroke along a
/// self-crossing path.
constexpr double longestOutline = 60'000;
constexpr double longestStroke = 4'000;
constexpr std::size_t mostOutlineLines = 1'000; ///< for curves, of the pieces that approximate them

std::vector<QPointF> positionsOf(const Shape &shape, const ViewMapping &mapping)
{
    std::vector<QPointF> positions;
    for (const Vertex &vertex : shape.vertices)
        positions.push_back(mapping.positionOf(vertex.position));
    return positions;
}

/// The pieces of a Bézier path in order, each with its control points, or the contours of a
/// polygon.
std::vector<std::span<const QPointF>> piecesOf(const Shape &path,
                                               const std::vector<QPointF> &points)
{
    std::vector<std::span<const QPointF>> pieces;
    const std::span<const QPointF> all(points);
    std::size_t first = 0;
    for (const std::size_t next : path.laterContours) {
        pieces.push_back(all.subspan(first, next - first));
        first = next;
    }
    pieces.push_back(all.subspan(first));
    return pieces;
}

/// The path of a Bézier shape. A filled one is closed with straight edges where the pieces leave
/// gaps.
QPainterPath bezierPath(const Shape &shape, const std::vector<QPointF> &points)
{
    QPainterPath path(points.front());
    for (const std::span<const QPointF> piece : piecesOf(shape, points)) {
        if (piece.front() != path.currentPosition())
            path.lineTo(piece.front());
        if (piece.size() == 3)
            path.quadTo(piece[1], piece[2]);
        else
            path.cubicTo(piece[1], piece[2], piece[3]);
    }
    if (shape.fill != ShapeFill::Outline)
        path.closeSubpath();
    return path;
}

/// The curve of the shape; empty for polygons, which consist of their contours' edges, and where
/// the vertices are all there is.
QPainterPath curveOf(const Shape &shape, const std::vector<QPointF> &points)
{
    QPainterPath path;
    switch (shape.kind) {
    case PrimitiveKind::Line:
        path.moveTo(points[0]);
        path.lineTo(points[1]);
        break;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse: {
        const QPointF corner = points[1] - points[0];
        path.addEllipse(points[0], std::abs(corner.x()), std::abs(corner.y()));
        break;
    }
    case PrimitiveKind::Bezier:
        path = bezierPath(shape, points);
        break;
    case PrimitiveKind::Polygon:
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Text:
        break;
    }
    return path;
}

bool hasCurves(const QPainterPath &path)
{
    for (int i = 0; i < path.elementCount(); ++i) {
        if (path.elementAt(i).isCurveTo())
            return true;
    }
    return false;
}

/// The part of an outline inside a rectangle: painters lose precision far outside. The extent may
/// be zero in either direction, as for a level line.
struct VisibleLines {
    std::vector<QLineF> lines; ///< in order along the outline
    double length = 0; ///< of all, logical pixels
    bool isTooDense = false; ///< there are more lines than these

    /// Adds a line's visible part; false when there is no room for more.
    bool add(const QPointF &from, const QPointF &to, const QRectF &rect)
    {
        if (const std::optional<QLineF> piece = clipped({from, to}, rect)) {
            lines.push_back(*piece);
            length += piece->length();
            isTooDense = lines.size() > mostOutlineLines || length > longestOutline;
        }
        return !isTooDense;
    }
};

VisibleLines visibleLines(const QPainterPath &path, const QRectF &rect)
{
    VisibleLines visible;
    // The pieces of larger curves are no longer straight to a pixel.
    const QRectF extent = path.boundingRect();
    if (std::max(extent.width(), extent.height()) > largestCurve && hasCurves(path))
        return visible;
    for (const QPolygonF &polygon : path.toSubpathPolygons()) {
        for (qsizetype i = 1; i < polygon.size(); ++i) {
            if (!visible.add(polygon[i - 1], polygon[i], rect))
                return visible;
        }
    }
    return visible;
}

/// Clips without a path: of many edges, most lie outside.
VisibleLines visibleEdges(const Shape &polygon, const std::vector<QPointF> &points,
                          const QRectF &rect)
{
    VisibleLines visible;
    for (const std::span<const QPointF> contour : piecesOf(polygon, points)) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            if (!visible.add(contour[i], contour[(i + 1) % contour.size()], rect))
                return visible;
        }
    }
    return visible;
}

/// Corners of the box of a long text: the extent of its first characters, extrapolated to the
/// others by their average.
std::vector<QPointF> textCorners(const Shape &text, const ViewMapping &mapping)
{
    constexpr std::size_t mostMeasured = 256; // bytes: a millisecond
    Shape beginning = text;
    beginning.text.resize(std::min(text.text.size(), mostMeasured));
    const double share = double(text.text.size()) / double(beginning.text.size());
    const LatticePoint &corner = text.vertices.front().position;
    const auto width = Lattice(double(advanceOf(beginning)) * share);
    return {mapping.positionOf(corner),
            mapping.positionOf(LatticePoint{corner.x + width, corner.y + text.textHeight})};
}

QPainterPath joined(const std::vector<QLineF> &lines)
{
    QPainterPath path;
    for (const QLineF &line : lines) {
        if (path.isEmpty() || path.currentPosition() != line.p1())
            path.moveTo(line.p1());
        path.lineTo(line.p2());
    }
    return path;
}

} // namespace

/// Draws one stroke along the whole path where that is fast enough: it has better joints but takes
/// far longer.
void FramePainter::drawOutlineLines(const std::vector<QLineF> &lines, double length)
{
    const QColor around = translucent(casing(), 0.8);
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setBrush(Qt::NoBrush);
    for (const QPen &pen : {QPen(around, outlineWidth + 2),
                            QPen(signColour(Sign::VertexMark, m_palette), outlineWidth)}) {
        m_painter.setPen(pen);
        if (length <= longestStroke)
            m_painter.drawPath(joined(lines));
        else
            m_painter.drawLines(lines.data(), int(lines.size()));
    }
}

void FramePainter::drawBounds(const std::vector<QPointF> &points)
{
    const auto [left, right] = std::ranges::minmax(points, {}, &QPointF::x);
    const auto [top, bottom] = std::ranges::minmax(points, {}, &QPointF::y);
    const std::array corners = {QPointF(left.x(), top.y()), QPointF(right.x(), top.y()),
                                QPointF(right.x(), bottom.y()), QPointF(left.x(), bottom.y())};
    for (std::size_t i = 0; i < corners.size(); ++i)
        drawCased({corners[i], corners[(i + 1) % corners.size()]},
                  signColour(Sign::VertexMark, m_palette), outlineWidth, Qt::DashLine);
}

void FramePainter::drawShapeOutline(const Shape &shape)
{
    if (shape.kind == PrimitiveKind::Text && shape.text.size() > mostOutlineLines)
        return drawBounds(textCorners(shape, m_mapping));
    const std::vector<QPointF> points = positionsOf(shape, m_mapping);
    const QRectF seen = m_view.adjusted(-9, -9, 9, 9);
    const VisibleLines visible = shape.kind == PrimitiveKind::Polygon
        ? visibleEdges(shape, points, seen)
        : visibleLines(curveOf(shape, points), seen);
    if (visible.isTooDense)
        return drawBounds(points);
    if (shape.kind == PrimitiveKind::Bezier && points.size() <= mostOutlineLines) {
        for (const std::span<const QPointF> piece : piecesOf(shape, points)) {
            for (std::size_t i = 1; i < piece.size(); ++i)
                drawCased({piece[i - 1], piece[i]}, signColour(Sign::VertexMark, m_palette), 1,
                          Qt::DotLine);
        }
    }
    // The corner is not on the curve: two tangents, each a radius long, connect it.
    if (shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse) {
        for (const QPointF &touching :
             {QPointF(points[0].x(), points[1].y()), QPointF(points[1].x(), points[0].y())})
            drawCased({points[1], touching}, signColour(Sign::VertexMark, m_palette), 1,
                      Qt::DotLine);
    }
    drawOutlineLines(visible.lines, visible.length);
}

void FramePainter::drawClippedPolygon(const std::vector<LatticePoint> &corners)
{
    QPointF inside;
    std::vector<QPointF> places;
    for (const LatticePoint &corner : corners) {
        places.push_back(m_mapping.positionOf(corner));
        inside += places.back() / double(corners.size());
    }
    const QColor colour = signColour(Sign::VertexMark, m_palette);
    for (std::size_t i = 2; i + 1 < places.size(); ++i)
        drawCased({places[0], places[i]}, colour, outlineWidth, Qt::DashLine);
    for (std::size_t i = 0; i < places.size(); ++i)
        drawCased({places[i], places[(i + 1) % places.size()]}, colour, clippedWidth);
    for (std::size_t i = 0; i < corners.size(); ++i)
        drawVertexName(u"C%1"_s.arg(i), corners[i], inside);
}

void FramePainter::drawOffScreenPoint(const LatticePoint &point)
{
    const QPointF place = m_mapping.positionOf(point);
    const QRectF inner
        = m_view.adjusted(offScreenSize, offScreenSize, -offScreenSize, -offScreenSize);
    const QPointF shown(std::clamp(place.x(), inner.left(), inner.right()),
                        std::clamp(place.y(), inner.top(), inner.bottom()));
    const QPointF beyond = place - shown;
    const double distance = std::hypot(beyond.x(), beyond.y());
    const QColor colour = signColour(Sign::VertexMark, m_palette);
    if (distance > offScreenSize) {
        const QPointF ahead = beyond / distance * offScreenSize;
        const QPointF aside(-ahead.y() / 2, ahead.x() / 2);
        drawCased({shown - ahead, shown + ahead}, colour, outlineWidth);
        drawCased({shown + ahead, shown + aside}, colour, outlineWidth);
        drawCased({shown + ahead, shown - aside}, colour, outlineWidth);
    } else {
        const QPointF across(offScreenSize, 0);
        const QPointF up(0, offScreenSize);
        for (const QLineF &side :
             {QLineF(place - across, place + up), QLineF(place + up, place + across),
              QLineF(place + across, place - up), QLineF(place - up, place - across)})
            drawCased(side, colour, outlineWidth);
    }
    drawNote(QCoreApplication::translate("pixelplumb::FramePainter", "off-screen point"),
             shown + QPointF(offScreenSize, 0), NoteSide::AboveRight);
}

void FramePainter::drawRubberPath(const std::vector<LatticePoint> &points)
{
    for (std::size_t i = 1; i < points.size(); ++i)
        drawRubberLine(points[i - 1], points[i]);
}

} // namespace pixelplumb
