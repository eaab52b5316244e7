// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/sideview.h"

#include "widgets/look/parts.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double degreesPerPixel = 0.5;
constexpr double degreesPerKey = 5;
constexpr double magnificationPerNotch = 1.25;
constexpr double wheelNotch = 120; // eighths of a degree

} // namespace

void OrbitView::turnBy(double turn, double tilt)
{
    m_turn = std::remainder(m_turn + turn, 360);
    m_tilt = std::clamp(m_tilt + tilt, -largestTilt, largestTilt);
}

void OrbitView::magnifyBy(double factor)
{
    m_magnification = std::clamp(m_magnification * factor, 1.0 / 8, 64.0);
}

void OrbitView::reset() { *this = {}; }

void OrbitView::fit(const std::vector<SpaceVector<double>> &points, const QRectF &rect)
{
    m_centre = rect.center();
    m_middle = {};
    m_scale = 1;
    if (points.empty() || rect.isEmpty())
        return;
    QPointF low = turned(points.front());
    QPointF high = low;
    for (const SpaceVector<double> &point : points) {
        const QPointF at = turned(point);
        low = {std::min(low.x(), at.x()), std::min(low.y(), at.y())};
        high = {std::max(high.x(), at.x()), std::max(high.y(), at.y())};
    }
    constexpr double least = 1e-9;
    m_middle = (low + high) / 2;
    m_scale = m_magnification
        * std::min(rect.width() / std::max(high.x() - low.x(), least),
                   rect.height() / std::max(high.y() - low.y(), least));
}

QPointF OrbitView::positionOf(const SpaceVector<double> &point) const
{
    const QPointF from = turned(point) - m_middle;
    return m_centre + QPointF(from.x(), -from.y()) * m_scale;
}

QPointF OrbitView::turned(const SpaceVector<double> &point) const
{
    const double turn = qDegreesToRadians(m_turn);
    const double tilt = qDegreesToRadians(m_tilt);
    const double forward = -point.z;
    const double across = forward * std::cos(turn) + point.x * std::sin(turn);
    const double towardsEye = -forward * std::sin(turn) + point.x * std::cos(turn);
    return {across, point.y * std::cos(tilt) - towardsEye * std::sin(tilt)};
}

SideView::SideView(QWidget *parent)
    : QWidget(parent)
{
    named(this, "sideView", tr("The camera from the side"),
          tr("The eye, the near plane, the picture plane and the rays to the current face. "
             "Drag to turn, wheel to magnify, double click to put it back."));
    onEvents(this, {QEvent::Resize}, [this] { refit(); });
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
}

void SideView::setScene(const std::optional<SideScene> &scene)
{
    m_scene = scene;
    m_face.reset();
    refit();
}

void SideView::setFace(const std::optional<SideFace> &face)
{
    m_face = face;
    update();
}

QPointF SideView::positionOf(const SpaceVector<double> &point) const
{
    return m_orbit.positionOf(point);
}

void SideView::refit()
{
    const int margin = 2 * fontMetrics().height(); // room for names
    if (m_scene)
        m_orbit.fit(m_scene->outline, rect().adjusted(margin, margin, -margin, -margin));
    update();
}

void SideView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return QWidget::mousePressEvent(event);
    m_dragged = event->position();
    setCursor(Qt::ClosedHandCursor);
}

void SideView::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_dragged)
        return;
    const QPointF way = event->position() - *m_dragged;
    m_dragged = event->position();
    m_orbit.turnBy(way.x() * degreesPerPixel, way.y() * degreesPerPixel);
    refit();
}

void SideView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return QWidget::mouseReleaseEvent(event);
    m_dragged.reset();
    setCursor(Qt::OpenHandCursor);
}

void SideView::mouseDoubleClickEvent(QMouseEvent * /*event*/)
{
    m_orbit.reset();
    refit();
}

void SideView::wheelEvent(QWheelEvent *event)
{
    m_orbit.magnifyBy(std::pow(magnificationPerNotch, event->angleDelta().y() / wheelNotch));
    refit();
    event->accept();
}

void SideView::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        m_orbit.turnBy(-degreesPerKey, 0);
        break;
    case Qt::Key_Right:
        m_orbit.turnBy(degreesPerKey, 0);
        break;
    case Qt::Key_Up:
        m_orbit.turnBy(0, -degreesPerKey);
        break;
    case Qt::Key_Down:
        m_orbit.turnBy(0, degreesPerKey);
        break;
    case Qt::Key_Plus:
        m_orbit.magnifyBy(magnificationPerNotch);
        break;
    case Qt::Key_Minus:
        m_orbit.magnifyBy(1 / magnificationPerNotch);
        break;
    case Qt::Key_Home:
        m_orbit.reset();
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    refit();
}

} // namespace pixelplumb
