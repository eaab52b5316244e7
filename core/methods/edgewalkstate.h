// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/anyarithmetic.h"
#include "core/scan/walks/edgewalk.h"
#include "core/trace/currentstep.h"

/// What the tables of edge walks read: the kernel's state with each number as a quantity, so that
/// one table serves every arithmetic.
namespace pixelplumb {

struct EdgeWalkSetUpState {
    ScanSettings settings;
    EdgeWalkSetUp<AnyArithmetic> walk;
};

/// Where the colours of a span start, and what that depends on.
struct EdgeWalkStart {
    bool hasPlane = false; ///< the triangle has an area
    bool isVertical = false; ///< it has none and lies in one column, from P0 to P2
    bool isClipped = false; ///< the frame begins after the lower bound
    bool isPoint = false; ///< the bounds are equal: there is no change between them
    Interval covered = Interval::Closed; ///< which bounds belong to the span
    bool hasPreStep = true; ///< to the first sample; false with the variant NoColourPreStep
    bool isOnePoint = false; ///< all vertices coincide
};

struct EdgeWalkSpanState {
    std::size_t primitive = 0;
    ScanSettings settings;
    std::array<Vertex, 3> corners; ///< P0, P1, P2
    std::array<std::size_t, 3> digits = {0, 1, 2}; ///< by which texts name the corners
    EdgeWalkStart start;
    ColumnState<AnyArithmetic> column; ///< for a row walk, in the plane turned to (−y, x)
    Quantity biasBottom, biasTop; ///< β of the two bounds, px
    SortedEdge lower = SortedEdge::L02;
    SortedEdge upper = SortedEdge::L02;
    bool isFirst = false; ///< the triangle's first span
    bool beginsHalf = false; ///< the first span of its half
    bool isCrossed = false; ///< rounding has exchanged the bounds since the previous span

    std::int64_t drawnSamples() const
    {
        return std::max<std::int64_t>(0, column.endDrawn - column.firstDrawn);
    }
    /// 1 or 2; none where the triangle is its edge L₀₂ alone.
    Quantity halfNumber() const
    {
        return start.hasPlane ? Quantity::integer(column.half == ColumnHalf::First ? 1 : 2)
                              : Quantity();
    }
};

struct EdgeWalkSampleState {
    EdgeWalkStart start;
    std::array<Quantity, 3> colour; ///< levels, before rounding
    bool isFirst = false; ///< the span's first sample in the frame
    Quantity bias; ///< β of the levels
};

template <class A>
EdgeWalkSetUpState edgeWalkStateOf(const CurrentSetUp<EdgeWalkSetUp<A>> &step)
{
    const ColumnSetUp<A> &scan = step.setUp.scan;
    EdgeWalkSetUpState state{
        step.settings, {{}, step.setUp.corners, step.setUp.intervals, step.setUp.firstOfFrame}};
    ColumnSetUp<AnyArithmetic> &shown = state.walk.scan;
    shown.order = scan.order;
    shown.longEdge = scan.longEdge;
    shown.zeroArea = scan.zeroArea;
    shown.firstColumn = scan.firstColumn;
    shown.middleColumn = scan.middleColumn;
    shown.endColumn = scan.endColumn;
    shown.slope = quantitiesOf(scan.slope);
    for (std::size_t edge = 0; edge < 3; ++edge)
        shown.colourRate[edge] = quantitiesOf(scan.colourRate[edge]);
    return state;
}

template <class A>
EdgeWalkStart edgeWalkStartOf(const EdgeWalkSetUp<A> &setUp, const ColumnState<A> &column,
                              VariantSet variants)
{
    const LatticePoint &p0 = setUp.corners[0].position;
    const LatticePoint &p2 = setUp.corners[2].position;
    return {!setUp.scan.zeroArea,
            setUp.scan.zeroArea && p0.x == p2.x && p0.y != p2.y,
            column.firstDrawn != column.firstRow,
            quantityOf(column.yBottom) == quantityOf(column.yTop),
            setUp.intervals.rows,
            setUp.scan.zeroArea || !variants.contains(Variant::NoColourPreStep),
            p0 == p2};
}

template <class A>
EdgeWalkSpanState edgeWalkStateOf(const CurrentSpan<EdgeWalkSetUp<A>, ColumnState<A>> &step)
{
    const ColumnSetUp<A> &scan = step.setUp.scan;
    const ColumnState<A> &column = step.span;
    EdgeWalkSpanState state;
    state.primitive = step.primitive;
    state.settings = step.settings;
    state.corners = step.setUp.corners;
    state.start = edgeWalkStartOf(step.setUp, column, step.settings.variants);
    state.column = {column.x,
                    column.half,
                    column.longEdge,
                    quantityOf(column.yBottom),
                    quantityOf(column.yTop),
                    quantitiesOf(column.colourBottom),
                    quantitiesOf(column.colourTop),
                    quantitiesOf(column.colourRate),
                    column.firstRow,
                    column.endRow,
                    column.firstDrawn,
                    column.endDrawn,
                    quantitiesOf(column.firstColour)};
    state.biasBottom = biasOf(column.yBottom);
    state.biasTop = biasOf(column.yTop);
    const SortedEdge shortEdge
        = column.half == ColumnHalf::First ? SortedEdge::L01 : SortedEdge::L12;
    if (!scan.zeroArea)
        (column.longEdge == LongEdge::Above ? state.lower : state.upper) = shortEdge;
    state.isFirst = !step.previous;
    state.isCrossed = step.previous && step.previous->longEdge != column.longEdge;
    state.beginsHalf = !step.previous || step.previous->half != column.half;
    return state;
}

/// `along` is the sample's coordinate along the span.
template <class A>
EdgeWalkSampleState edgeWalkStateOf(
    const CurrentSample<EdgeWalkSetUp<A>, ColumnState<A>, Fragment<A>> &step, std::int64_t along)
{
    return {edgeWalkStartOf(step.setUp, step.span, step.settings.variants),
            quantitiesOf(step.sample.colour), along == step.span.firstDrawn,
            biasOf(step.sample.colour[0])};
}

} // namespace pixelplumb
