// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/spacevector.h"

#include <QPointF>
#include <QRectF>

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
    double magnification() const { return m_magnification; } ///< 1: all points fit

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
    double m_magnification = 1;
    double m_scale = 1; ///< logical pixels per unit
    QPointF m_middle; ///< of the points, turned
    QPointF m_centre; ///< of the rectangle
};

} // namespace pixelplumb
