// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/spacevector.h"
#include "widgets/space/sidescene.h"

#include <QtWidgets>

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// A view of the camera from the side: camera coordinates (x to the right, y up, the camera looking
/// along −z), turned and tilted, drawn without perspective. Before any turn the camera looks to the
/// right.
class OrbitView {
public:
    static constexpr double largestTilt = 90; ///< degrees

    double turn() const { return m_turn; } ///< about the camera's up, degrees
    double tilt() const { return m_tilt; } ///< seen from above, degrees

    void turnBy(double turn, double tilt); ///< degrees; the tilt stops at ±largestTilt
    void magnifyBy(double factor); ///< within 1/8 … 64
    void reset();

    /// Fits the points into a rectangle, logical pixels; positionOf() then maps accordingly.
    void fit(const std::vector<SpaceVector<double>> &points, const QRectF &rect);
    QPointF positionOf(const SpaceVector<double> &point) const;

    static constexpr double firstTurn = -25;
    static constexpr double firstTilt = 15;

private:
    /// Turned and tilted, not yet scaled; y upward.
    QPointF turned(const SpaceVector<double> &point) const;

    double m_turn = firstTurn;
    double m_tilt = firstTilt;
    double m_magnification = 1; ///< 1: all points fit
    double m_scale = 1; ///< logical pixels per unit
    QPointF m_middle; ///< of the points, turned
    QPointF m_centre; ///< of the rectangle
};

/// The eye, the near plane, the picture plane, the solids and the rays to the current face, seen
/// from the side (objectName "sideView"). A drag or the arrow keys turn it, the wheel or + and −
/// magnify it, a double click resets it.
class SideView : public QWidget {
    Q_OBJECT

public:
    explicit SideView(QWidget *parent = nullptr);

    /// Without a scene nothing is drawn.
    void setScene(const std::optional<SideScene> &scene);
    void setFace(const std::optional<SideFace> &face);

    const OrbitView &orbit() const { return m_orbit; }
    /// Where a point in camera coordinates is drawn.
    QPointF positionOf(const SpaceVector<double> &point) const;

    QSize sizeHint() const override { return {420, 300}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    using Point = SpaceVector<double>;

    void refit();
    QPolygonF polygonOf(std::span<const Point> points) const;
    void drawScene(QPainter &painter);
    void drawPlane(QPainter &painter, const SideScene::Rectangle &plane, const QString &name);
    void drawRays(QPainter &painter) const;
    void drawFace(QPainter &painter);
    void drawPicture(QPainter &painter);
    void drawSample(QPainter &painter) const;
    void drawEye(QPainter &painter);
    void drawLine(QPainter &painter, const Point &from, const Point &to) const;
    /// Draws a name near a position of the widget, clear of the other names.
    void drawName(QPainter &painter, const QString &name, const QPointF &position,
                  const QPointF &wished);

    std::optional<SideScene> m_scene;
    std::optional<SideFace> m_face;
    OrbitView m_orbit;
    std::optional<QPointF> m_dragged; ///< the pointer's last position
    std::vector<QRectF> m_names; ///< of the names in this painting
};

} // namespace pixelplumb
