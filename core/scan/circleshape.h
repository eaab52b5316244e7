// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/number/wideproduct.h"
#include "core/scan/linestep.h"

namespace pixelplumb {

/// A circle or an ellipse as kernels see it: its centre and its radii, lattice units.
struct Round {
    LatticePoint centre;
    Lattice radiusX = 0;
    Lattice radiusY = 0;

    static Round of(const Shape &shape)
    {
        const LatticePoint centre = shape.vertices[0].position;
        return {centre, shape.vertices[1].position.x - centre.x,
                shape.vertices[1].position.y - centre.y};
    }
    bool isCircle() const { return radiusX == radiusY; }

    StepRange columns() const
    {
        return {ceilPixel(centre.x - radiusX), floorPixel(centre.x + radiusX) + 1};
    }
    StepRange rows() const
    {
        return {ceilPixel(centre.y - radiusY), floorPixel(centre.y + radiusY) + 1};
    }
    /// Whether a pixel that is nearest to the curve or inside can lie in the frame.
    bool mayTouch(FrameView frame) const
    {
        const auto widened = [](StepRange range) {
            return StepRange{range.first - 1, range.end + 1};
        };
        return !widened(columns()).clippedTo(StepRange::along(frame, LineAxis::X)).isEmpty()
            && !widened(rows()).clippedTo(StepRange::along(frame, LineAxis::Y)).isEmpty();
    }
};

/// ⌊b·√(1 − (d/a)²)⌋ in lattice units for |d| <= a: half the chord at a distance d from the centre.
/// Whether a lattice point lies beyond the chord's end depends on this integer alone. Found bit by
/// bit, by comparing squares.
constexpr Lattice halfChord(Lattice a, Lattice b, Lattice distance)
{
    if (a == 0)
        return b;
    const WideProduct square = wideProduct(UInt128(Int128(b) * (a - absolute(distance))),
                                           UInt128(Int128(b) * (a + absolute(distance))));
    Lattice half = 0;
    for (Lattice bit = Lattice(1) << 40; bit > 0; bit >>= 1) {
        if (half + bit <= b && wideSquare(Int128(a) * (half + bit)) <= square)
            half += bit;
    }
    return half;
}

} // namespace pixelplumb
