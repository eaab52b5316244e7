// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

namespace pixelplumb {

/// The plane of each level over a triangle, without rounding: R(x, y) = (c0·A + GX·(x − x0) +
/// GY·(y − y0))/A, with A the doubled area and lengths in lattice units. A triangle of zero area
/// has none. The caller chooses an integer that holds the products.
template <class Integer>
struct LevelPlane {
    Integer area = 0; ///< doubled, without sign
    std::array<Integer, 3> perX = {}; ///< GX
    std::array<Integer, 3> perY = {}; ///< GY

    LevelPlane() = default;
    LevelPlane(const Vertex &p0, const Vertex &p1, const Vertex &p2)
    {
        const Integer x1 = Integer(p1.position.x) - p0.position.x;
        const Integer y1 = Integer(p1.position.y) - p0.position.y;
        const Integer x2 = Integer(p2.position.x) - p0.position.x;
        const Integer y2 = Integer(p2.position.y) - p0.position.y;
        const Integer signedArea = x1 * y2 - x2 * y1;
        const Integer sign = signedArea < 0 ? -1 : 1;
        area = signedArea * sign;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const Integer c0 = p0.colour.channels[channel];
            const Integer c1 = p1.colour.channels[channel] - c0;
            const Integer c2 = p2.colour.channels[channel] - c0;
            perX[channel] = sign * (c1 * y2 - c2 * y1);
            perY[channel] = sign * (c2 * x1 - c1 * x2);
        }
    }

    /// A level times the area, `along` and `up` from p0, lattice units.
    [[gnu::always_inline]] Integer numerator(const Vertex &p0, std::size_t channel,
                                             const Integer &along, const Integer &up) const
    {
        return Integer(p0.colour.channels[channel]) * area + perX[channel] * along
            + perY[channel] * up;
    }
};

} // namespace pixelplumb
