// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/anyarithmetic.h"
#include "core/scan/lines/outlinefill.h"
#include "core/trace/currentstep.h"
#include "core/trace/numberrow.h"
#include "core/trace/stepwords.h"

/// The numbers and words of a filled outline by the midpoint algorithm.
namespace pixelplumb {

/// The decision that led to a pixel of the outline; none at its edge's start.
struct OutlineDecision {
    Quantity across; ///< px that the line had gone across before
    Quantity parameter; ///< p_k
};

struct OutlineSpanState {
    std::size_t primitive = 0;
    OutlineFillSetUp setUp;
    OutlineFillSpan<AnyArithmetic> span;
    OutlineDecision lowDecision, highDecision;

    std::int64_t drawnSamples() const
    {
        return std::max<std::int64_t>(0, span.column.endDrawn - span.column.firstDrawn);
    }
    /// A column of one pixel has no change of colour.
    bool hasRate() const { return span.low.row != span.high.row; }
};

struct OutlineSampleState {
    std::array<Quantity, 3> colour; ///< levels, before rounding
    bool isFirst = false; ///< the column's first pixel in the frame
    bool hasRate = false;
};

const NumberTable<OutlineFillSetUp> &outlineSetUpNumbers();
const NumberTable<OutlineSpanState> &outlineSpanNumbers();
const NumberTable<OutlineSampleState> &outlineSampleNumbers();

void tellOutline(StepWords &words, const OutlineFillSetUp &setUp);
void tellOutline(StepWords &words, const OutlineSpanState &state);

/// Uses the function with which the kernel finds the pixel.
inline OutlineDecision outlineDecisionOf(const OutlineFillSetUp &setUp, const OutlinePixel &pixel)
{
    const BresenhamSetUp &line = setUp.edges[pixel.edge].line;
    const BresenhamStep step = bresenhamStepAt(line, pixel.number);
    if (step.isStart())
        return {};
    const bool moved = step.increment == line.moveIncrement;
    const std::int64_t across = line.acrossStep * (step.place.across - line.start.y);
    return {Quantity::integer(across - (moved ? 1 : 0)), Quantity::integer(step.decision)};
}

template <class A>
OutlineSpanState outlineStateOf(const CurrentSpan<OutlineFillSetUp, OutlineFillSpan<A>> &step)
{
    const ColumnState<A> &column = step.span.column;
    OutlineSpanState state{step.primitive,
                           step.setUp,
                           {step.span.low, step.span.high, {}},
                           outlineDecisionOf(step.setUp, step.span.low),
                           outlineDecisionOf(step.setUp, step.span.high)};
    ColumnState<AnyArithmetic> &shown = state.span.column;
    shown.x = column.x;
    shown.firstRow = column.firstRow;
    shown.endRow = column.endRow;
    shown.firstDrawn = column.firstDrawn;
    shown.endDrawn = column.endDrawn;
    shown.colourBottom = quantitiesOf(column.colourBottom);
    shown.colourTop = quantitiesOf(column.colourTop);
    shown.colourRate = quantitiesOf(column.colourRate);
    shown.firstColour = quantitiesOf(column.firstColour);
    return state;
}

template <class A>
OutlineSampleState outlineStateOf(
    const CurrentSample<OutlineFillSetUp, OutlineFillSpan<A>, Fragment<A>> &step)
{
    return {quantitiesOf(step.sample.colour), step.y == step.span.column.firstDrawn,
            step.span.low.row != step.span.high.row};
}

} // namespace pixelplumb
