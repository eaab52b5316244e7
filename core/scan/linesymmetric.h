// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/linebresenham.h"

/// Bresenham's line with a rule for ties that does not know directions, and from any lattice point
/// to any other. It is always walked along growing coordinates, and of two pixels that are equally
/// near it takes the upper one (the right one where the line is steep). The decision parameter is
/// the same number as Bresenham's, in units of 1/S² so that it stays an integer between pixels.
namespace pixelplumb {

struct SymmetricSetUp {
    LineAxis axis = LineAxis::X;
    Vertex start, end; ///< exchanged; start.position.x <= end.position.x
    int acrossStep = 1; ///< +1 or −1: where a step across leads
    Lattice deltaX = 0; ///< Δx >= 0, lattice units
    Lattice deltaY = 0; ///< Δy, without its sign

    constexpr Int128 stayIncrement() const { return Int128(2) * deltaY * unitsPerPixel; }
    constexpr Int128 moveIncrement() const
    {
        return stayIncrement() - Int128(2) * deltaX * unitsPerPixel;
    }
    /// S²: what 1 is in a decision parameter.
    static constexpr Int128 decisionUnit() { return Int128(unitsPerPixel) * unitsPerPixel; }
};

/// One pixel, and what decides about the next one.
struct SymmetricStep {
    LinePlace place;
    bool isFirst = true; ///< placed by a division: no decision led here
    std::int64_t k = -1; ///< the number of the decision that led here
    Int128 decision = 0; ///< p_k; of the first pixel, none
    Int128 increment = 0;
    Int128 nextDecision = 0;
    std::array<ExactArithmetic<Int128>::Number, 3> colour = {}; ///< levels
};

struct SymmetricNumbers {
    using SetUp = SymmetricSetUp;
    using Span = SymmetricStep;
    using Sample = Fragment<ExactArithmetic<Int128>>;
};

constexpr SymmetricSetUp symmetricSetUp(const Shape &line)
{
    SymmetricSetUp setUp;
    setUp.axis = lineAxisOf(line.vertices[0].position, line.vertices[1].position);
    setUp.start = exchanged(line.vertices[0], setUp.axis);
    setUp.end = exchanged(line.vertices[1], setUp.axis);
    if (setUp.end.position.x < setUp.start.position.x)
        std::swap(setUp.start, setUp.end);
    setUp.acrossStep = setUp.end.position.y < setUp.start.position.y ? -1 : 1;
    setUp.deltaX = setUp.end.position.x - setUp.start.position.x;
    setUp.deltaY = absolute(setUp.end.position.y - setUp.start.position.y);
    return setUp;
}

/// The pixel on a column of the line, by one division, and the decision about the next column's:
/// p = 2·s·(y(x + 1) − y_k)·Δx·S² − Δx·S², s the sign of the slope.
constexpr SymmetricStep symmetricStepAt(const SymmetricSetUp &setUp, std::int64_t along)
{
    const Int128 width = setUp.deltaX == 0 ? 1 : setUp.deltaX; // of a point: any
    const Int128 rise = Int128(setUp.acrossStep) * setUp.deltaY;
    const LatticePoint &start = setUp.start.position;
    // y·ΔX·S, the line's ordinate at this column and at the next.
    const Int128 ordinate = start.y * width + (Int128(along) * unitsPerPixel - start.x) * rise;
    const Int128 next = ordinate + rise * unitsPerPixel;
    const Int128 unit = width * unitsPerPixel;
    SymmetricStep step;
    step.place
        = {setUp.axis, along, std::int64_t(floorDivide<Int128>(2 * ordinate + unit, 2 * unit))};
    step.k = along - ceilPixel(start.x) - 1;
    step.nextDecision = Int128(setUp.acrossStep) * 2 * (next - step.place.across * unit) - unit;
    return step;
}

/// From the pixel of a step to the next one. A tie, p = 0, goes up: it moves where the line rises
/// and stays where it falls.
constexpr void advance(const SymmetricSetUp &setUp, SymmetricStep &step)
{
    step.isFirst = false;
    ++step.k;
    ++step.place.along;
    step.decision = step.nextDecision;
    const bool moves = setUp.acrossStep > 0 ? step.decision >= 0 : step.decision > 0;
    step.increment = moves ? setUp.moveIncrement() : setUp.stayIncrement();
    step.place.across += moves ? setUp.acrossStep : 0;
    step.nextDecision = step.decision + step.increment;
}

template <ScanObserver<SymmetricNumbers> Observer>
void scanLineSymmetrically(const Shape &line, ByteRounding rounding, FrameView frame,
                           Observer observer)
{
    using A = ExactArithmetic<Int128>;
    const SymmetricSetUp setUp = symmetricSetUp(line);
    observer.primitiveBegun(setUp);
    const StepRange columns
        = StepRange{ceilPixel(setUp.start.position.x), floorPixel(setUp.end.position.x) + 1}
              .clippedTo(StepRange::along(frame, setUp.axis));
    if (columns.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    SymmetricStep step = symmetricStepAt(setUp, columns.first);
    for (std::int64_t along = columns.first; along < columns.end; ++along) {
        step.place.findIn(frame);
        for (std::size_t channel = 0; channel < 3; ++channel)
            step.colour[channel] = A::edgeColour(setUp.start, setUp.end, channel, along);
        observer.spanEntered(step);
        plot<A>(step.place, step.colour, rounding, frame, observer);
        advance(setUp, step);
    }
}

} // namespace pixelplumb
