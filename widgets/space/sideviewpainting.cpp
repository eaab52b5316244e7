// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/framepainter.h"
#include "widgets/look/signs.h"
#include "widgets/space/sideview.h"

#include <QtWidgets>

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

constexpr double dotRadius = 3; // logical pixels
constexpr double nameDistance = 6;

/// The signs of the direction from a polygon's middle to one of its corners.
QPointF sideAwayFrom(const QPolygonF &polygon, int corner)
{
    const QPointF away = polygon[corner] - polygon.boundingRect().center();
    return {away.x() < 0 ? -1.0 : 1.0, away.y() > 0 ? 1.0 : -1.0};
}

} // namespace

void SideView::paintEvent(QPaintEvent * /*event*/)
{
    if (!m_scene)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    m_names.clear();
    drawEye(painter);
    drawScene(painter);
    if (m_face) {
        drawRays(painter);
        drawFace(painter);
        drawPicture(painter);
        drawSample(painter);
    }
}

QPolygonF SideView::polygonOf(std::span<const Point> points) const
{
    QPolygonF polygon;
    for (const Point &point : points)
        polygon << positionOf(point);
    return polygon;
}

/// Clips first: painters lose precision far outside.
void SideView::drawLine(QPainter &painter, const Point &from, const Point &to) const
{
    const QLineF line(positionOf(from), positionOf(to));
    if (const auto seen = clipped(line, QRectF(rect()).adjusted(-4, -4, 4, 4)))
        painter.drawLine(*seen);
}

/// Draws the name on the side given by the signs, where there is room; farther away, with a line to
/// it.
void SideView::drawName(QPainter &painter, const QString &name, const QPointF &position,
                        const QPointF &wished)
{
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(name), metrics.height());
    const QRectF area(rect());
    QRectF place;
    // On the wished side, then around the position, then farther away; the first free place, or the
    // first of all.
    std::array sides = {QPointF(1, -1), QPointF(-1, -1), QPointF(1, 1), QPointF(-1, 1)};
    std::stable_partition(sides.begin(), sides.end(),
                          [&](const QPointF &side) { return side == wished; });
    for (const double distance : {nameDistance, 4 * nameDistance, 7 * nameDistance}) {
        for (const QPointF &side : sides) {
            QRectF tried(position + side * distance, size);
            tried.translate(side.x() < 0 ? -size.width() : 0, -size.height() / 2);
            if (place.isNull())
                place = tried;
            const bool isFree = area.contains(tried)
                && std::ranges::none_of(m_names, [&tried](const QRectF &other) {
                                    return other.intersects(tried);
                                });
            if (!isFree)
                continue;
            place = tried;
            m_names.push_back(place);
            if (distance > nameDistance)
                painter.drawLine(position, position + side * distance);
            painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, name);
            return;
        }
    }
    painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, name);
}

void SideView::drawScene(QPainter &painter)
{
    painter.setPen(QPen(translucent(palette().color(QPalette::Text), 0.3), 0.75));
    for (const auto &[from, to] : m_scene->edges)
        drawLine(painter, from, to);
    painter.setPen(QPen(translucent(palette().color(QPalette::Text), 0.5), 1, Qt::DotLine));
    for (std::size_t i = 0; i < 4; ++i) {
        const Point &corner = m_scene->picturePlane[i];
        drawLine(painter, m_scene->isPerspective ? Point() : Point(corner.x, corner.y, 0), corner);
    }
    drawPlane(painter, m_scene->nearPlane, tr("near plane"));
    drawPlane(painter, m_scene->picturePlane, tr("picture plane"));
}

void SideView::drawPlane(QPainter &painter, const SideScene::Rectangle &plane, const QString &name)
{
    const QColor text = palette().color(QPalette::Text);
    painter.setPen(QPen(translucent(text, 0.8), 1));
    painter.setBrush(translucent(text, 0.06));
    const QPolygonF polygon = polygonOf(plane);
    painter.drawPolygon(polygon);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(text);
    const QRectF box = polygon.boundingRect();
    // Each name on the side away from the other plane.
    const bool isNear = &plane == &m_scene->nearPlane;
    drawName(painter, name, box.topRight(), QPointF(isNear ? -1 : 1, -1));
}

void SideView::drawRays(QPainter &painter) const
{
    const QColor colour = signColour(Sign::CurrentColumn, palette());
    for (const Point &vertex : m_face->vertices) {
        // What lies before the near plane is invisible.
        const bool isSeen = -vertex.z >= -m_scene->nearPlane[0].z;
        painter.setPen(QPen(colour, 1, isSeen ? Qt::SolidLine : Qt::DashLine));
        drawLine(painter, m_scene->isPerspective ? Point() : Point(vertex.x, vertex.y, 0), vertex);
    }
    painter.setPen(QPen(translucent(colour, 0.6), 1));
    for (const Point &corner : m_face->clipped) {
        drawLine(painter, m_scene->isPerspective ? Point() : Point(corner.x, corner.y, 0), corner);
    }
}

void SideView::drawFace(QPainter &painter)
{
    const QColor text = palette().color(QPalette::Text);
    const QColor colour = signColour(Sign::CurrentColumn, palette());
    painter.setPen(QPen(translucent(colour, 0.7), 1, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(polygonOf(m_face->vertices));
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(translucent(colour, 0.25));
    painter.drawPolygon(polygonOf(m_face->clipped));
    painter.setPen(text);
    for (std::size_t i = 0; i < m_face->vertices.size(); ++i)
        drawName(painter, faceVertexName(i), positionOf(m_face->vertices[i]),
                 sideAwayFrom(polygonOf(m_face->vertices), int(i)));
}

/// Draws the face's picture, each corner in its colour.
void SideView::drawPicture(QPainter &painter)
{
    const QColor colour = signColour(Sign::CurrentColumn, palette());
    painter.setPen(QPen(translucent(colour, 0.7), 1));
    painter.setBrush(translucent(colour, 0.15));
    painter.drawPolygon(polygonOf(m_face->picture));
    if (m_face->picture.size() >= 3) {
        const auto &[a, b, c] = m_face->piece;
        const std::array piece = {m_face->picture[a], m_face->picture[b], m_face->picture[c]};
        painter.setPen(QPen(colour, 1.5));
        painter.drawPolygon(polygonOf(piece));
    }
    for (std::size_t i = 0; i < m_face->picture.size(); ++i) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1));
        painter.setBrush(QColor(packed(m_face->colours[i])));
        painter.drawEllipse(positionOf(m_face->picture[i]), dotRadius, dotRadius);
        drawName(painter, clippedCornerName(i), positionOf(m_face->picture[i]),
                 sideAwayFrom(polygonOf(m_face->picture), int(i)));
    }
    painter.setBrush(Qt::NoBrush);
}

void SideView::drawSample(QPainter &painter) const
{
    if (!m_face->sample)
        return;
    const auto &[picture, face] = *m_face->sample;
    const QColor colour = signColour(Sign::PickedPixel, palette());
    painter.setPen(QPen(colour, 1.5));
    drawLine(painter, m_scene->isPerspective ? Point() : Point(picture.x, picture.y, 0), face);
    painter.setBrush(colour);
    for (const Point &point : {picture, face})
        painter.drawEllipse(positionOf(point), dotRadius, dotRadius);
    painter.setBrush(Qt::NoBrush);
}

void SideView::drawEye(QPainter &painter)
{
    const QPointF eye = positionOf({});
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    painter.setBrush(palette().color(QPalette::Base));
    QPainterPath lid;
    lid.moveTo(eye + QPointF(-9, 0));
    lid.quadTo(eye + QPointF(0, -10), eye + QPointF(9, 0));
    lid.quadTo(eye + QPointF(0, 10), eye + QPointF(-9, 0));
    painter.drawPath(lid);
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawEllipse(eye, dotRadius, dotRadius);
    drawName(painter, m_scene->isPerspective ? tr("eye") : tr("eye (far away)"),
             eye + QPointF(nameDistance, -nameDistance), {1, -1});
}

} // namespace pixelplumb
