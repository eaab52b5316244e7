// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

#include <compare>

namespace pixelplumb {

/// A coordinate in lattice units: 1/256 px, like Direct3D's 8 bits of sub-pixel precision.
using Lattice = std::int64_t;

inline constexpr Lattice unitsPerPixel = 256;
inline constexpr Lattice halfPixel = unitsPerPixel / 2;

/// The largest coordinate in magnitude: 2^30 px. Larger ones never reach a kernel.
inline constexpr Lattice largestPixel = Lattice(1) << 30;
inline constexpr Lattice largestCoordinate = largestPixel * unitsPerPixel;

/// Up to this coordinate (2^15 px) all exact products fit 64 bits (resources/numerics.md, 3.1 and
/// 3.3).
inline constexpr Lattice largestNarrowCoordinate = (Lattice(1) << 15) * unitsPerPixel;

/// A point on the lattice; ordered by x, then y, as the column scan sorts its vertices.
struct LatticePoint {
    Lattice x = 0;
    Lattice y = 0;

    friend constexpr auto operator<=>(const LatticePoint &, const LatticePoint &) = default;
};

constexpr LatticePoint latticePixel(std::int64_t x, std::int64_t y)
{
    return {x * unitsPerPixel, y * unitsPerPixel};
}

/// The first sample coordinate at or after a lattice coordinate: ⌈c⌉ in pixels.
constexpr std::int64_t ceilPixel(Lattice coordinate)
{
    return ceilDivide(coordinate, unitsPerPixel);
}

/// The last sample coordinate at or before a lattice coordinate: ⌊c⌋ in pixels.
constexpr std::int64_t floorPixel(Lattice coordinate)
{
    return floorDivide(coordinate, unitsPerPixel);
}

constexpr bool isWithinRange(const LatticePoint &point)
{
    return absolute(point.x) <= largestCoordinate && absolute(point.y) <= largestCoordinate;
}

constexpr bool isNarrow(const LatticePoint &point)
{
    const auto isNarrow = [](Lattice coordinate) {
        return coordinate >= -largestNarrowCoordinate && coordinate <= largestNarrowCoordinate;
    };
    return isNarrow(point.x) && isNarrow(point.y);
}

} // namespace pixelplumb
