// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/exactarithmetic.h"
#include "core/scan/linestep.h"
#include "core/scan/scanobserver.h"

/// Bresenham's line in all octants (seed 002, "Bresenham's Line Algorithm"): each step goes one
/// pixel along the line, and the sign of an integer, the decision parameter p, tells whether it
/// also goes one across. A tie, p = 0, goes across, as in the slides' table (their rule prints p <=
/// 0 for staying; resources/misprints.md). Lines are walked from the first end to the second, so
/// that the pixel of a tie lies on the second end's side: the reversed line may have other pixels.
namespace pixelplumb {

/// Everything that does not change along the line; x and y exchanged where it is steep, and both
/// counted from the start in the direction of the line, so that 0 <= Δy <= Δx.
struct BresenhamSetUp {
    LineAxis axis = LineAxis::X;
    LatticePoint start; ///< px, exchanged
    int alongStep = 1; ///< +1 or −1: the direction along the line
    int acrossStep = 1; ///< +1 or −1: where a step across leads
    std::int64_t deltaX = 0; ///< Δx, px
    std::int64_t deltaY = 0; ///< Δy, px

    constexpr std::int64_t stayIncrement() const { return 2 * deltaY; }
    constexpr std::int64_t moveIncrement() const { return 2 * deltaY - 2 * deltaX; }
    constexpr std::int64_t firstDecision() const { return 2 * deltaY - deltaX; } ///< p₀
};

/// One pixel of the line: the one after the decision p_k; the start comes before any.
struct BresenhamStep {
    LinePlace place;
    std::int64_t k = -1; ///< the decision's number; −1 at the start
    std::int64_t decision = 0; ///< p_k; of the start, none
    std::int64_t increment = 0; ///< what makes p_k the next one
    std::int64_t nextDecision = 0; ///< p_k+1

    bool isStart() const { return k < 0; }
};

constexpr BresenhamSetUp bresenhamSetUp(const LatticePoint &from, const LatticePoint &to)
{
    BresenhamSetUp setUp;
    setUp.axis = lineAxisOf(from, to);
    const bool isSteep = setUp.axis == LineAxis::Y;
    setUp.start = isSteep ? LatticePoint{from.y, from.x} : from;
    const LatticePoint end = isSteep ? LatticePoint{to.y, to.x} : to;
    setUp.alongStep = end.x < setUp.start.x ? -1 : 1;
    setUp.acrossStep = end.y < setUp.start.y ? -1 : 1;
    setUp.deltaX = absolute(end.x - setUp.start.x);
    setUp.deltaY = absolute(end.y - setUp.start.y);
    return setUp;
}

/// From the pixel of a step to the next one.
constexpr void advance(const BresenhamSetUp &setUp, BresenhamStep &step)
{
    ++step.k;
    step.decision = step.nextDecision;
    step.place.along += setUp.alongStep;
    if (step.decision < 0) {
        step.increment = setUp.stayIncrement();
    } else {
        step.place.across += setUp.acrossStep;
        step.increment = setUp.moveIncrement();
    }
    step.nextDecision = step.decision + step.increment;
}

/// The pixel with a number from the start, 0 … Δx: where advance() comes to in as many steps, at
/// the cost of one. After n steps the line has gone ⌊n·Δy/Δx + 1/2⌋ across.
constexpr BresenhamStep bresenhamStepAt(const BresenhamSetUp &setUp, std::int64_t pixel)
{
    BresenhamStep step;
    step.nextDecision = setUp.firstDecision();
    step.place = {setUp.axis, setUp.start.x, setUp.start.y};
    if (pixel == 0)
        return step;
    const std::int64_t before = pixel - 1;
    const auto moves = floorDivide<Int128>(2 * Int128(before) * setUp.deltaY + setUp.deltaX,
                                           2 * Int128(setUp.deltaX));
    step.k = before - 1;
    step.place.along += setUp.alongStep * before;
    step.place.across += setUp.acrossStep * std::int64_t(moves);
    step.nextDecision = std::int64_t(2 * Int128(pixel) * setUp.deltaY - setUp.deltaX
                                     - 2 * Int128(setUp.deltaX) * moves);
    advance(setUp, step);
    return step;
}

/// The pixels of the line, by their numbers from the start, that lie on the frame's columns (rows
/// where it is steep).
constexpr StepRange bresenhamPixelsIn(const BresenhamSetUp &setUp, FrameView frame)
{
    const StepRange shown = StepRange::along(frame, setUp.axis);
    const StepRange whole = {0, setUp.deltaX + 1};
    return whole.clippedTo(
        setUp.alongStep > 0
            ? StepRange{shown.first - setUp.start.x, shown.end - setUp.start.x}
            : StepRange{setUp.start.x - shown.end + 1, setUp.start.x - shown.first + 1});
}

/// Integers decide about pixels, and exact fractions about colours.
using BresenhamArithmetic = ExactArithmetic<std::int64_t>;

/// The pixel of a step with its colour.
struct BresenhamSpan {
    BresenhamStep step;
    std::array<BresenhamArithmetic::Number, 3> colour = {}; ///< levels
};

struct BresenhamNumbers {
    using SetUp = BresenhamSetUp;
    using Span = BresenhamSpan;
    using Sample = Fragment<BresenhamArithmetic>;
};

/// The pixel nearest to a vertex, with the vertex' colour: the algorithm knows whole pixels alone.
constexpr Vertex onPixel(Vertex vertex)
{
    vertex.position = latticePixel(floorPixel(vertex.position.x + unitsPerPixel / 2),
                                   floorPixel(vertex.position.y + unitsPerPixel / 2));
    return vertex;
}

template <ScanObserver<BresenhamNumbers> Observer>
void scanLineByBresenham(const Shape &line, ByteRounding rounding, FrameView frame,
                         Observer observer)
{
    Vertex a = onPixel(line.vertices[0]);
    Vertex b = onPixel(line.vertices[1]);
    const auto pixelOf = [](const Vertex &vertex) {
        return LatticePoint{floorPixel(vertex.position.x), floorPixel(vertex.position.y)};
    };
    const BresenhamSetUp setUp = bresenhamSetUp(pixelOf(a), pixelOf(b));
    observer.primitiveBegun(setUp);
    const StepRange pixels = bresenhamPixelsIn(setUp, frame);
    if (pixels.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    a = exchanged(a, setUp.axis);
    b = exchanged(b, setUp.axis);
    if (b.position.x < a.position.x)
        std::swap(a, b);
    BresenhamSpan span;
    span.step = bresenhamStepAt(setUp, pixels.first);
    for (std::int64_t pixel = pixels.first; pixel < pixels.end; ++pixel) {
        span.step.place.findIn(frame);
        for (std::size_t channel = 0; channel < 3; ++channel)
            span.colour[channel]
                = BresenhamArithmetic::edgeColour(a, b, channel, span.step.place.along);
        observer.spanEntered(span);
        plot<BresenhamArithmetic>(span.step.place, span.colour, rounding, frame, observer);
        advance(setUp, span.step);
    }
}

} // namespace pixelplumb
