// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/levelplane.h"
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
        , m_plane(triangle.vertices[0], triangle.vertices[1], triangle.vertices[2])
    {
    }

    /// At a sample, px; inside and outside.
    ExactLevel at(std::size_t channel, std::int64_t x, std::int64_t y) const
    {
        const LatticePoint sample = latticePixel(x, y);
        const Int128 sum = m_plane.numerator(m_origin, channel, sample.x - m_origin.position.x,
                                             sample.y - m_origin.position.y);
        const Int128 whole = floorDivide<Int128>(sum, m_plane.area);
        return {whole, sum - whole * m_plane.area, m_plane.area};
    }

private:
    Vertex m_origin;
    LevelPlane<Int128> m_plane;
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
