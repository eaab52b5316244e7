// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/lines/linebresenham.h"

/// Bresenham's line between any two lattice points, with a tie rule that ignores slopes. It is
/// always walked along growing coordinates, and of two equally near pixels it takes the upper one
/// (the right one where the line is steep). The decision parameter is Bresenham's, in units of
/// 1/S², so that it stays an integer between pixels.
namespace pixelplumb {

template <class Integer>
struct SymmetricSetUpOf {
    LineAxis axis = LineAxis::X;
    Vertex start, end; ///< exchanged; start.position.x <= end.position.x
    int acrossStep = 1; ///< +1 or −1: where a step across leads
    Lattice deltaX = 0; ///< Δx >= 0, lattice units
    Lattice deltaY = 0; ///< Δy|
    Integer stayIncrement = 0; ///< 2Δy·S
    Integer moveIncrement = 0; ///< (2Δy − 2Δx)·S

    /// S²: the value of a decision parameter that stands for 1.
    static constexpr Int128 decisionUnit() { return Int128(unitsPerPixel) * unitsPerPixel; }
};
using SymmetricSetUp = SymmetricSetUpOf<Int128>;

/// One pixel, and the numbers that decide the next one.
template <class Integer>
struct SymmetricStepOf {
    LinePlace place;
    bool isFirst = true; ///< placed by a division: no decision led here
    std::int64_t k = -1; ///< the number of the decision that led here
    Integer decision = 0; ///< p_k; none at the first pixel
    Integer increment = 0;
    Integer nextDecision = 0;
    std::array<MixedNumber<Integer>, 3> colour = {}; ///< levels
};
using SymmetricStep = SymmetricStepOf<Int128>;

template <class Integer>
struct SymmetricNumbersOf {
    using SetUp = SymmetricSetUpOf<Integer>;
    using Span = SymmetricStepOf<Integer>;
    using Sample = Fragment<ExactArithmetic<Integer>>;
};
using SymmetricNumbers = SymmetricNumbersOf<Int128>;

template <class Integer = Int128>
constexpr SymmetricSetUpOf<Integer> symmetricSetUp(const Shape &line)
{
    SymmetricSetUpOf<Integer> setUp;
    setUp.axis = lineAxisOf(line.vertices[0].position, line.vertices[1].position);
    setUp.start = exchanged(line.vertices[0], setUp.axis);
    setUp.end = exchanged(line.vertices[1], setUp.axis);
    if (setUp.end.position.x < setUp.start.position.x)
        std::swap(setUp.start, setUp.end);
    setUp.acrossStep = setUp.end.position.y < setUp.start.position.y ? -1 : 1;
    const Integer deltaX = Integer(setUp.end.position.x) - setUp.start.position.x;
    const Integer deltaY
        = absolute<Integer>(Integer(setUp.end.position.y) - setUp.start.position.y);
    setUp.deltaX = Lattice(deltaX);
    setUp.deltaY = Lattice(deltaY);
    setUp.stayIncrement = 2 * deltaY * unitsPerPixel;
    setUp.moveIncrement = setUp.stayIncrement - 2 * deltaX * unitsPerPixel;
    return setUp;
}

/// The pixel on a column of the line, by one division, and the decision about the next column: p =
/// 2·s·(y(x + 1) − y_k)·Δx·S² − Δx·S², s the sign of the slope.
template <class Integer>
constexpr SymmetricStepOf<Integer> symmetricStepAt(const SymmetricSetUpOf<Integer> &setUp,
                                                   std::int64_t along)
{
    const Integer width = setUp.deltaX == 0 ? 1 : setUp.deltaX; // any width serves a point
    const Integer rise = Integer(setUp.acrossStep) * setUp.deltaY;
    const LatticePoint &start = setUp.start.position;
    // y·ΔX·S, the line's ordinate at this column and at the next.
    const Integer ordinate = start.y * width + (Integer(along) * unitsPerPixel - start.x) * rise;
    const Integer next = ordinate + rise * unitsPerPixel;
    const Integer unit = width * unitsPerPixel;
    SymmetricStepOf<Integer> step;
    step.place
        = {setUp.axis, along, std::int64_t(floorDivide<Integer>(2 * ordinate + unit, 2 * unit))};
    step.k = along - ceilPixel(start.x) - 1;
    step.nextDecision = Integer(setUp.acrossStep) * 2 * (next - step.place.across * unit) - unit;
    return step;
}

/// Goes on to the next pixel. A tie, p = 0, goes up: it moves where the line rises and stays where
/// it falls.
template <class Integer>
constexpr void advance(const SymmetricSetUpOf<Integer> &setUp, SymmetricStepOf<Integer> &step)
{
    step.isFirst = false;
    ++step.k;
    ++step.place.along;
    step.decision = step.nextDecision;
    const bool moves = setUp.acrossStep > 0 ? step.decision >= 0 : step.decision > 0;
    step.increment = moves ? setUp.moveIncrement : setUp.stayIncrement;
    step.place.across += moves ? setUp.acrossStep : 0;
    step.nextDecision = step.decision + step.increment;
}

template <class Integer, ScanObserver<SymmetricNumbersOf<Integer>> Observer>
void scanLineSymmetrically(const Shape &line, ByteRounding rounding, FrameView frame,
                           Observer observer)
{
    using A = ExactArithmetic<Integer>;
    const SymmetricSetUpOf<Integer> setUp = symmetricSetUp<Integer>(line);
    observer.primitiveBegun(setUp);
    const StepRange columns
        = StepRange{ceilPixel(setUp.start.position.x), floorPixel(setUp.end.position.x) + 1}
              .clippedTo(StepRange::along(frame, setUp.axis));
    if (columns.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    SymmetricStepOf<Integer> step = symmetricStepAt(setUp, columns.first);
    EdgeColours<A> colours;
    colours.start(setUp.start, setUp.end, A::runTo(columns.first, setUp.start));
    step.colour = colours.colour;
    for (std::int64_t along = columns.first; along < columns.end; ++along) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        step.place.findIn(frame);
        observer.spanEntered(step);
        plot<A>(step.place, step.colour, rounding, frame, observer);
        advance(setUp, step);
        colours.stepToNextColumn();
        step.colour = colours.colour;
    }
}

} // namespace pixelplumb
