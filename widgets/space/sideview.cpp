// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/sideview.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace pixelplumb {

namespace {

constexpr double degreesPerPixel = 0.5;
constexpr double degreesPerKey = 5;
constexpr double magnificationPerNotch = 1.25;
constexpr double wheelNotch = 120; // eighths of a degree

} // namespace

SideView::SideView(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("sideView"));
    setAccessibleName(tr("The camera from the side"));
    setToolTip(tr("The eye, the near plane, the picture plane and the rays to the current face. "
                  "Drag to turn, wheel to magnify, double click to put it back."));
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

void SideView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    refit();
}

} // namespace pixelplumb
