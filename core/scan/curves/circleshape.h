// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/number/companiontypes.h"
#include "core/number/widerinteger.h"
#include "core/scan/lines/linestep.h"

#include <cmath>

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
    /// Whether a pixel nearest to the curve or inside it can lie in the frame.
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
/// This integer alone decides whether a lattice point lies beyond the chord's end. A double is off
/// by less than 1 (its error is about 2^-50 of less than 2^39); integer squares correct it.
template <class Integer = Int128>
Lattice halfChord(Lattice a, Lattice b, Lattice distance)
{
    if (a == 0)
        return b;
    using std::sqrt;
    using Wider = TwiceAsWide<Integer>;
    using Real = RealBeside<Integer>;
    const Integer along = absolute<Integer>(distance);
    const Integer beside = (a - along) * (a + along);
    const Wider square = Wider(beside) * b * b; // a²·(half the chord)²
    const auto isWithin = [&](Lattice half) {
        const Wider scaled = Wider(a) * half;
        return scaled * scaled <= square;
    };
    auto half = Lattice(Real(b) * sqrt(Real(beside)) / Real(a));
    while (!isWithin(half))
        --half;
    while (isWithin(half + 1))
        ++half;
    return half;
}

} // namespace pixelplumb
