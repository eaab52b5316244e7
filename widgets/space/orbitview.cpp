// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/orbitview.h"

#include <QtMath>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

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

} // namespace pixelplumb
