// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layermoment.h"

#include <array>

namespace pixelplumb {

/// The implicit equation of a triangle's edge: value = A·x + B·y + C.
struct EdgeLineNumbers {
    QString name; ///< "E₀", "f_bc"
    Quantity a, b; ///< for each px
    QPointF from, to; ///< the vertices between which it lies, px

    /// Its value at a place, px; computed by A and B from the vertex `from`, where it is 0.
    double valueAt(const QPointF &place) const
    {
        return a.toDouble() * (place.x() - from.x()) + b.toDouble() * (place.y() - from.y());
    }
};

/// Where numbers come from.
enum class NumberOrigin { Kernel, Exact };

struct EdgeLines {
    std::array<EdgeLineNumbers, 3> lines;
    NumberOrigin origin = NumberOrigin::Kernel;
};

/// The three lines of the method's set-up; if it has none, the oracle's edges 0–1, 1–2, 2–0,
/// positive inside.
EdgeLines edgeLinesOf(const LayerMoment &moment);

} // namespace pixelplumb
