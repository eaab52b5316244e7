// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"
#include "core/space/spacevector.h"

#include <algorithm>

namespace pixelplumb {

/// The cubic Bernstein polynomials (1−t)³, 3t(1−t)², 3t²(1−t), t³.
template <class Number>
std::array<Number, 4> bernstein(const Number &t)
{
    const Number s = 1 - t;
    return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}

/// The derivatives of the Bernstein polynomials.
template <class Number>
std::array<Number, 4> bernsteinSlopes(const Number &t)
{
    const Number s = 1 - t;
    return {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
}

/// A bicubic Bézier patch, P(u, v) = Σᵢ Σⱼ Bᵢ(v) Bⱼ(u) Pᵢⱼ with row i and column j of its 16
/// control points [Farin 2002].
template <class Number>
class BezierPatch {
public:
    explicit BezierPatch(const Solid &solid)
        : m_corners(solid.corners)
    {
        const SpaceVector<Number> first(m_corners[0].position);
        for (const SolidCorner &corner : m_corners) {
            const SpaceVector<Number> arm = SpaceVector<Number>(corner.position) - first;
            m_squaredSize = std::max(m_squaredSize, dot(arm, arm));
        }
    }

    SpaceVector<Number> point(const Number &u, const Number &v) const
    {
        return sum(bernstein(u), bernstein(v));
    }

    /// ∂P/∂u × ∂P/∂v, normalized. Where the tangents span no plane, the normal at a parameter
    /// slightly nearer to the middle; 0 where they span none there either.
    SpaceVector<Number> normal(const Number &u, const Number &v) const
    {
        const SpaceVector<Number> normal = tangentsCross(u, v);
        if (!isTiny(normal))
            return unit(normal);
        const Number nudge = Number(1) / 1024;
        const Number half = Number(1) / 2;
        return unit(tangentsCross(between(u, half, nudge), between(v, half, nudge)));
    }

private:
    SpaceVector<Number> alongU(const Number &u, const Number &v) const
    {
        return sum(bernsteinSlopes(u), bernstein(v));
    }
    SpaceVector<Number> alongV(const Number &u, const Number &v) const
    {
        return sum(bernstein(u), bernsteinSlopes(v));
    }
    SpaceVector<Number> tangentsCross(const Number &u, const Number &v) const
    {
        return cross(alongU(u, v), alongV(u, v));
    }
    /// Whether rounding alone explains the length, given the size of the control net.
    bool isTiny(const SpaceVector<Number> &normal) const
    {
        return lengthOf(normal) <= m_squaredSize / (Number(1 << 20) * Number(1 << 20));
    }
    SpaceVector<Number> sum(const std::array<Number, 4> &columns,
                            const std::array<Number, 4> &rows) const
    {
        SpaceVector<Number> point;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                const Number weight = rows[i] * columns[j];
                point = point + weight * SpaceVector<Number>(m_corners[4 * i + j].position);
            }
        }
        return point;
    }

    const std::vector<SolidCorner> &m_corners;
    Number m_squaredSize = Number(0);
};

} // namespace pixelplumb
