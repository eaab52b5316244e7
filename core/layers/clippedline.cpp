// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/clippedline.h"

#include <algorithm>

namespace pixelplumb {

std::optional<QLineF> clipped(const QLineF &line, const QRectF &rect)
{
    // Liang and Barsky 1984: the parameters at which the line enters and leaves each side.
    double enters = 0;
    double leaves = 1;
    const auto cut = [&](double direction, double distance) {
        if (direction == 0)
            return distance >= 0;
        const double at = distance / direction;
        if (direction < 0)
            enters = std::max(enters, at);
        else
            leaves = std::min(leaves, at);
        return enters <= leaves;
    };
    if (!cut(-line.dx(), line.x1() - rect.left()) || !cut(line.dx(), rect.right() - line.x1())
        || !cut(-line.dy(), line.y1() - rect.top()) || !cut(line.dy(), rect.bottom() - line.y1()))
        return std::nullopt;
    return QLineF(line.pointAt(enters), line.pointAt(leaves));
}

} // namespace pixelplumb
