// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/number/quantity.h"

/// How far a kernel's number is from the exact level.
namespace pixelplumb {

/// whole + remainder / denominator, 0 <= remainder < denominator.
struct ExactLevel {
    Int128 whole = 0;
    Int128 remainder = 0;
    Int128 denominator = 1;

    double fraction() const { return double(remainder) / double(denominator); }
};

/// The exact levels of a triangle's plane; the triangle must have area.
class ExactLevels {
public:
    explicit ExactLevels(const Triangle &triangle)
        : m_origin(triangle.vertices[0])
    {
        const auto &[p, q, r] = triangle.vertices;
        const Int128 x1 = q.position.x - p.position.x, y1 = q.position.y - p.position.y;
        const Int128 x2 = r.position.x - p.position.x, y2 = r.position.y - p.position.y;
        m_area = x1 * y2 - x2 * y1;
        const Int128 sign = m_area < 0 ? -1 : 1;
        m_area *= sign;
        for (std::size_t i = 0; i < 3; ++i) {
            const Int128 c1 = q.colour.channels[i] - p.colour.channels[i];
            const Int128 c2 = r.colour.channels[i] - p.colour.channels[i];
            m_perX[i] = sign * (c1 * y2 - c2 * y1);
            m_perY[i] = sign * (c2 * x1 - c1 * x2);
        }
    }

    /// At a sample, px; inside and outside.
    ExactLevel at(std::size_t channel, std::int64_t x, std::int64_t y) const
    {
        const LatticePoint sample = latticePixel(x, y);
        const Int128 sum = m_origin.colour.channels[channel] * m_area
            + m_perX[channel] * (sample.x - m_origin.position.x)
            + m_perY[channel] * (sample.y - m_origin.position.y);
        const Int128 whole = floorDivide<Int128>(sum, m_area);
        return {whole, sum - whole * m_area, m_area};
    }

private:
    Vertex m_origin;
    Int128 m_area = 0; ///< doubled, square lattice units
    std::array<Int128, 3> m_perX = {}; ///< of the level times the area, for each lattice unit
    std::array<Int128, 3> m_perY = {};
};

/// used − exact, levels; 0 only if two fractions are equal. The wholes are subtracted first, so
/// that an error near the level is accurate to some 10^-16.
inline double levelError(const ExactLevel &exact, const Quantity &used)
{
    if (!used.isRational())
        return (used.toDouble() - double(exact.whole)) - exact.fraction();
    const Int128 denominator = used.denominator();
    const Int128 whole = floorDivide<Int128>(used.numerator(), denominator);
    const Int128 remainder = used.numerator() - whole * denominator;
    constexpr Int128 factorsFit = Int128(1) << 63;
    if (exact.denominator >= factorsFit || denominator >= factorsFit)
        return double(whole - exact.whole)
            + (double(remainder) / double(denominator) - exact.fraction());
    const Int128 crossed = remainder * exact.denominator - exact.remainder * denominator;
    return double(whole - exact.whole)
        + double(crossed) / (double(denominator) * double(exact.denominator));
}

} // namespace pixelplumb
