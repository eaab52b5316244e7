// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/edgewalker.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/lines/linestep.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

/// Bresenham's line in all octants (Rasterization slides, "Bresenham's Line Algorithm"): each step
/// goes one pixel along the line, and the sign of an integer, the decision parameter p, tells
/// whether it also goes one across. A tie, p = 0, goes across, as in the slides' table (their
/// printed rule stays for p <= 0; resources/misprints.md). Lines are walked from their left end
/// ("Store left line endpoint in (x₀, y₀)"). Steep ones, whose x and y are exchanged, start at the
/// end with the smaller y; so a line has the same pixels whichever end is given first.
namespace pixelplumb {

/// Everything that does not change along the line. x and y are exchanged where it is steep, and
/// both are counted from the start in the line's direction, so that 0 <= Δy <= Δx.
template <class Integer>
struct BresenhamSetUpOf {
    LineAxis axis = LineAxis::X;
    LatticePoint start; ///< px, exchanged
    int alongStep = 1; ///< +1 or −1: the direction along the line
    int acrossStep = 1; ///< +1 or −1: where a step across leads
    std::int64_t deltaX = 0; ///< Δx, px
    std::int64_t deltaY = 0; ///< Δy, px
    Integer stayIncrement = 0; ///< 2Δy
    Integer moveIncrement = 0; ///< 2Δy − 2Δx
    Integer firstDecision = 0; ///< p₀ = 2Δy − Δx
    Integer leastMove = 0; ///< the least p that goes across: 0, or 1 where p ≤ 0 stays, as printed
    std::int64_t steps = 0; ///< how often step 4 is done: Δx times, or Δx − 1 times, as printed
};
using BresenhamSetUp = BresenhamSetUpOf<std::int64_t>;

/// One pixel of the line: the one after the decision p_k; the start precedes all decisions.
template <class Integer>
struct BresenhamStepOf {
    LinePlace place;
    std::int64_t k = -1; ///< the decision's number; −1 at the start
    Integer decision = 0; ///< p_k; none at the start
    Integer increment = 0; ///< added to p_k to give p_k+1
    Integer nextDecision = 0; ///< p_k+1

    bool isStart() const { return k < 0; }
};
using BresenhamStep = BresenhamStepOf<std::int64_t>;

template <class Integer = std::int64_t>
constexpr BresenhamSetUpOf<Integer> bresenhamSetUp(const LatticePoint &from, const LatticePoint &to,
                                                   VariantSet variants = {})
{
    BresenhamSetUpOf<Integer> setUp;
    setUp.axis = lineAxisOf(from, to);
    const bool isSteep = setUp.axis == LineAxis::Y;
    setUp.start = isSteep ? LatticePoint{from.y, from.x} : from;
    const LatticePoint end = isSteep ? LatticePoint{to.y, to.x} : to;
    setUp.alongStep = end.x < setUp.start.x ? -1 : 1;
    setUp.acrossStep = end.y < setUp.start.y ? -1 : 1;
    const Integer deltaX = absolute<Integer>(Integer(end.x) - setUp.start.x);
    const Integer deltaY = absolute<Integer>(Integer(end.y) - setUp.start.y);
    setUp.deltaX = std::int64_t(deltaX);
    setUp.deltaY = std::int64_t(deltaY);
    setUp.stayIncrement = 2 * deltaY;
    setUp.moveIncrement = setUp.stayIncrement - 2 * deltaX;
    setUp.firstDecision = setUp.stayIncrement - deltaX;
    setUp.leastMove = variants.contains(Variant::StayAtZero) ? 1 : 0;
    const bool isShort = variants.contains(Variant::OneStepShort) && setUp.deltaX > 0;
    setUp.steps = setUp.deltaX - (isShort ? 1 : 0);
    return setUp;
}

/// Goes on to the next pixel.
template <class Integer>
constexpr void advance(const BresenhamSetUpOf<Integer> &setUp, BresenhamStepOf<Integer> &step)
{
    ++step.k;
    step.decision = step.nextDecision;
    step.place.along += setUp.alongStep;
    if (step.decision < setUp.leastMove) {
        step.increment = setUp.stayIncrement;
    } else {
        step.place.across += setUp.acrossStep;
        step.increment = setUp.moveIncrement;
    }
    step.nextDecision = step.decision + step.increment;
}

/// The pixel with a number from the start, 0 … Δx: where that many calls of advance() lead, at the
/// cost of one. After n steps the line has gone ⌊n·Δy/Δx + 1/2⌋ across; where p = 0 stays, a half
/// is not rounded up.
template <class Integer>
constexpr BresenhamStepOf<Integer> bresenhamStepAt(const BresenhamSetUpOf<Integer> &setUp,
                                                   std::int64_t pixel)
{
    using Wide = WideBeside<Integer>;
    BresenhamStepOf<Integer> step;
    step.nextDecision = setUp.firstDecision;
    step.place = {setUp.axis, setUp.start.x, setUp.start.y};
    if (pixel == 0)
        return step;
    const std::int64_t before = pixel - 1;
    const auto moves
        = floorDivide<Wide>(2 * Wide(before) * setUp.deltaY + setUp.deltaX - Wide(setUp.leastMove),
                            2 * Wide(setUp.deltaX));
    step.k = before - 1;
    step.place.along += setUp.alongStep * before;
    step.place.across += setUp.acrossStep * std::int64_t(moves);
    step.nextDecision
        = Integer(2 * Wide(pixel) * setUp.deltaY - setUp.deltaX - 2 * Wide(setUp.deltaX) * moves);
    advance(setUp, step);
    return step;
}

/// The line's pixels, by their numbers from the start, in the frame's columns (rows where it is
/// steep).
template <class Integer>
constexpr StepRange bresenhamPixelsIn(const BresenhamSetUpOf<Integer> &setUp, FrameView frame)
{
    const StepRange shown = StepRange::along(frame, setUp.axis);
    const StepRange whole = {0, setUp.steps + 1};
    return whole.clippedTo(
        setUp.alongStep > 0
            ? StepRange{shown.first - setUp.start.x, shown.end - setUp.start.x}
            : StepRange{setUp.start.x - shown.end + 1, setUp.start.x - shown.first + 1});
}

/// Integers decide about pixels, and exact fractions about colours.
using BresenhamArithmetic = ExactArithmetic<std::int64_t>;

/// The pixel of a step with its colour.
template <class Integer>
struct BresenhamSpanOf {
    BresenhamStepOf<Integer> step;
    std::array<MixedNumber<Integer>, 3> colour = {}; ///< levels
};
using BresenhamSpan = BresenhamSpanOf<std::int64_t>;

template <class Integer>
struct BresenhamNumbersOf {
    using SetUp = BresenhamSetUpOf<Integer>;
    using Span = BresenhamSpanOf<Integer>;
    using Sample = Fragment<ExactArithmetic<Integer>>;
};
using BresenhamNumbers = BresenhamNumbersOf<std::int64_t>;

/// The pixel nearest to a vertex, with its colour: the algorithm knows only whole pixels.
constexpr Vertex onPixel(Vertex vertex)
{
    vertex.position = latticePixel(floorPixel(vertex.position.x + unitsPerPixel / 2),
                                   floorPixel(vertex.position.y + unitsPerPixel / 2));
    return vertex;
}

template <class Integer, ScanObserver<BresenhamNumbersOf<Integer>> Observer>
void scanLineByBresenham(const Shape &line, const ScanSettings &settings, FrameView frame,
                         Observer observer)
{
    using Colours = ExactArithmetic<Integer>;
    Vertex a = onPixel(line.vertices[0]);
    Vertex b = onPixel(line.vertices[1]);
    const LineAxis axis = lineAxisOf(a.position, b.position);
    if (exchanged(b, axis).position.x < exchanged(a, axis).position.x)
        std::swap(a, b);
    const auto pixelOf = [](const Vertex &vertex) {
        return LatticePoint{floorPixel(vertex.position.x), floorPixel(vertex.position.y)};
    };
    const BresenhamSetUpOf<Integer> setUp
        = bresenhamSetUp<Integer>(pixelOf(a), pixelOf(b), settings.variants);
    observer.primitiveBegun(setUp);
    const StepRange pixels = bresenhamPixelsIn(setUp, frame);
    if (pixels.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    a = exchanged(a, setUp.axis);
    b = exchanged(b, setUp.axis);
    BresenhamSpanOf<Integer> span;
    span.step = bresenhamStepAt(setUp, pixels.first);
    EdgeColours<Colours> colours;
    colours.start(a, b, Colours::runTo(span.step.place.along, a));
    span.colour = colours.colour;
    for (std::int64_t pixel = pixels.first; pixel < pixels.end; ++pixel) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        span.step.place.findIn(frame);
        observer.spanEntered(span);
        plot<Colours>(span.step.place, span.colour, settings.rounding, frame, observer);
        advance(setUp, span.step);
        colours.stepToNextColumn();
        span.colour = colours.colour;
    }
}

} // namespace pixelplumb
