// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace pixelplumb {

/// A polygon clipped by half-planes (Sutherland and Hodgman 1974). Each cut adds at most half as
/// many corners as there are: from three at most 13 in the end, from four 19. A polygon that
/// crosses itself keeps its signed area, in which every point counts as often as the border winds
/// around it.
template <class Number, std::size_t mostCorners>
class ClippedPolygon {
public:
    void append(Number x, Number y)
    {
        Corner &corner = m_corners[m_count++];
        corner.x = std::move(x);
        corner.y = std::move(y);
    }

    /// Keeps the part in [−half, half] × [−half, half].
    void clipToSquare(const Number &half)
    {
        for (const int sign : {-1, 1}) {
            clip(&Corner::x, sign, half);
            clip(&Corner::y, sign, half);
        }
    }
    /// Twice the area: positive where the corners run counterclockwise, y upward.
    Number doubledArea() const
    {
        Number sum = 0;
        for (std::size_t i = 0; i < m_count; ++i) {
            const Corner &a = m_corners[i];
            const Corner &b = m_corners[(i + 1) % m_count];
            sum += a.x * b.y - b.x * a.y;
        }
        return sum;
    }

private:
    struct Corner {
        Number x, y;
    };

    /// Keeps the part with sign·coordinate <= bound.
    void clip(Number Corner::*axis, int sign, const Number &bound)
    {
        ClippedPolygon kept;
        for (std::size_t i = 0; i < m_count; ++i) {
            const Corner &a = m_corners[i];
            const Corner &b = m_corners[(i + 1) % m_count];
            const Number toA = bound - sign * (a.*axis);
            const Number toB = bound - sign * (b.*axis);
            if (toA >= 0)
                kept.append(a.x, a.y);
            if ((toA > 0 && toB < 0) || (toA < 0 && toB > 0)) {
                const Number part = toA / (toA - toB);
                kept.append(Number(a.x + (b.x - a.x) * part), Number(a.y + (b.y - a.y) * part));
            }
        }
        *this = kept;
    }

    std::array<Corner, mostCorners> m_corners;
    std::size_t m_count = 0;
};

} // namespace pixelplumb
