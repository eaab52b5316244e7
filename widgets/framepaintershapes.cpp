// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/framepainter.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

/// Outlines of the primitives that are not triangles.
namespace pixelplumb {

namespace {

constexpr double outlineWidth = 1.5; // logical pixels

std::vector<QPointF> positionsOf(const Shape &shape, const ViewMapping &mapping)
{
    std::vector<QPointF> positions;
    for (const Vertex &vertex : shape.vertices)
        positions.push_back(mapping.positionOf(vertex.position));
    return positions;
}

void appendContour(QPainterPath &path, const std::vector<QPointF> &points, std::size_t first,
                   std::size_t end)
{
    path.moveTo(points[first]);
    for (std::size_t i = first + 1; i < end; ++i)
        path.lineTo(points[i]);
    path.closeSubpath();
}

QPainterPath polygonPath(const Shape &shape, const std::vector<QPointF> &points)
{
    QPainterPath path;
    std::size_t first = 0;
    for (const std::size_t next : shape.laterContours) {
        appendContour(path, points, first, next);
        first = next;
    }
    appendContour(path, points, first, points.size());
    return path;
}

/// The curve that the shape stands for; empty where its vertices say it all.
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
        path.moveTo(points[0]);
        if (points.size() == 3)
            path.quadTo(points[1], points[2]);
        else
            path.cubicTo(points[1], points[2], points[3]);
        break;
    case PrimitiveKind::Polygon:
        path = polygonPath(shape, points);
        break;
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Text:
        break;
    }
    return path;
}

} // namespace

void FramePainter::drawShapeOutline(const Shape &shape)
{
    const std::vector<QPointF> points = positionsOf(shape, m_mapping);
    if (shape.kind == PrimitiveKind::Bezier) {
        for (std::size_t i = 1; i < points.size(); ++i)
            drawCased({points[i - 1], points[i]}, signColour(Sign::VertexMark, m_palette), 1,
                      Qt::DotLine);
    }
    const QPainterPath path = curveOf(shape, points);
    // Painters lose precision on paths that reach far out of the view.
    if (path.isEmpty() || !m_view.adjusted(-4096, -4096, 4096, 4096).contains(path.boundingRect()))
        return;
    QColor around = casing();
    around.setAlphaF(0.8F);
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(around, outlineWidth + 2));
    m_painter.drawPath(path);
    m_painter.setPen(QPen(signColour(Sign::VertexMark, m_palette), outlineWidth));
    m_painter.drawPath(path);
}

void FramePainter::drawRubberPath(const std::vector<LatticePoint> &points)
{
    for (std::size_t i = 1; i < points.size(); ++i)
        drawRubberLine(points[i - 1], points[i]);
}

} // namespace pixelplumb
