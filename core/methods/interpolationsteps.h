// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/anyarithmetic.h"
#include "core/methods/edgewalknames.h"
#include "core/methods/edgewalkstate.h"
#include "core/scan/interpolationscan.h"
#include "core/trace/stepinhand.h"

/// What the tables of interpolations read: the kernel's numbers as quantities, so that one table
/// serves every arithmetic.
namespace pixelplumb {

/// Without an area there is no plane and there are no weights: these are none.
struct InterpolationSetUpState : InterpolationSetUp<Quantity> {
    std::array<std::array<Quantity, 4>, channelCount> normal; ///< A B C D, [channel]
    std::array<std::array<Quantity, 4>, 3> line; ///< A B C k, [vertex]
    /// Of the bilinear form: what each column adds along an edge, by SortedEdge; none where the
    /// edge is vertical.
    std::array<Quantity, 3> slope;
    std::array<std::array<Quantity, channelCount>, 3> rate;

    /// Whether the vertices carry anything in this channel.
    bool carries(std::size_t channel) const
    {
        return channel < 3 || std::ranges::any_of(vertices, [channel](const ChannelVertex &vertex) {
                   return vertex.channels[channel] != 0;
               });
    }
};

struct InterpolationSpanState {
    EdgeWalkSpanState walk; ///< which edges bound the column, and whether the walk goes on
    InterpolationColumn<Quantity> column;

    std::int64_t drawnSamples() const
    {
        return std::max<std::int64_t>(0, column.endDrawn - column.firstDrawn);
    }
    /// Equal bounds have no change between them to share out.
    bool hasRate() const { return walk.start.hasPlane && !(column.yBottom == column.yTop); }
};

struct InterpolationSampleState : InterpolationSample<Quantity> {
    std::array<int, 3> order = {0, 1, 2}; ///< P0, P1, P2 in the caller's triangle
    EdgeWalkStart start;
    bool isPoint = false; ///< all vertices are one
};

template <InterpolationForm Form, class Number>
InterpolationSetUpState interpolationStateOf(const InterpolationSetUp<Number> &setUp)
{
    InterpolationSetUpState state{
        {setUp.order, setUp.longEdge, setUp.zeroArea, setUp.vertices, {}, {}}, {}, {}, {}, {}};
    const auto corner = [&](std::size_t number) -> const ChannelVertex & {
        return setUp.vertices[std::size_t(setUp.order[number])];
    };
    for (std::size_t edge = 0; edge < 3 && Form == InterpolationForm::Bilinear; ++edge) {
        const auto &ends = sortedEdgeEnds[edge];
        const ChannelVertex &a = corner(ends[0]);
        const ChannelVertex &b = corner(ends[1]);
        if (a.position.x == b.position.x
            || (setUp.zeroArea && edge != std::size_t(SortedEdge::L02)))
            continue;
        const ChannelEdge<Number> walked(a, b, 0);
        state.slope[edge] = Quantity::of(walked.slope);
        state.rate[edge] = quantitiesOf(walked.rate);
    }
    if (setUp.zeroArea)
        return state;
    for (std::size_t channel = 0; channel < channelCount && Form == InterpolationForm::Plane;
         ++channel) {
        const auto normal = planeNormal<Number>(setUp.vertices, channel);
        state.normal[channel] = quantitiesOf(std::array{normal.a, normal.b, normal.c, normal.d});
        state.plane[channel] = quantitiesOf(setUp.plane[channel]);
    }
    for (std::size_t vertex = 0; vertex < 3 && Form == InterpolationForm::Barycentric; ++vertex) {
        const auto line = scaledLine<Number>(setUp.vertices, vertex);
        state.line[vertex] = quantitiesOf(std::array{line.a, line.b, line.c, line.k});
        state.weight[vertex] = quantitiesOf(setUp.weight[vertex]);
    }
    return state;
}

/// How a column's walk along the edges is told, as the edge walks tell theirs.
template <class Number>
EdgeWalkSpanState interpolationWalkOf(
    const SpanInHand<InterpolationSetUp<Number>, InterpolationColumn<Number>> &step)
{
    const InterpolationSetUp<Number> &setUp = step.setUp;
    EdgeWalkSpanState walk;
    walk.primitive = step.primitive;
    for (std::size_t corner = 0; corner < 3; ++corner)
        walk.corners[corner].position = setUp.vertices[std::size_t(setUp.order[corner])].position;
    const LatticePoint &p0 = walk.corners[0].position;
    const LatticePoint &p2 = walk.corners[2].position;
    walk.start = {!setUp.zeroArea, setUp.zeroArea && p0.x == p2.x && p0.y != p2.y,
                  step.span.firstDrawn != step.span.firstRow,
                  Quantity::of(step.span.yBottom) == Quantity::of(step.span.yTop),
                  columnIntervals(step.settings.fillRule).rows};
    walk.column.x = step.span.x;
    walk.column.half = step.span.half;
    const SortedEdge shortEdge
        = step.span.half == ColumnHalf::First ? SortedEdge::L01 : SortedEdge::L12;
    if (!setUp.zeroArea)
        (setUp.longEdge == LongEdge::Above ? walk.lower : walk.upper) = shortEdge;
    walk.isFirst = !step.previous;
    walk.beginsHalf = !step.previous || step.previous->half != step.span.half;
    return walk;
}

template <class Number>
InterpolationSpanState interpolationStateOf(
    const SpanInHand<InterpolationSetUp<Number>, InterpolationColumn<Number>> &step)
{
    const InterpolationColumn<Number> &column = step.span;
    return {interpolationWalkOf(step),
            {column.x, column.half, column.lower, column.upper, column.firstRow, column.endRow,
             column.firstDrawn, column.endDrawn, Quantity::of(column.yBottom),
             Quantity::of(column.yTop), quantitiesOf(column.bottom), quantitiesOf(column.top),
             quantitiesOf(column.rate), quantitiesOf(column.first)}};
}

template <class Number>
InterpolationSampleState interpolationStateOf(
    const SampleInHand<InterpolationSetUp<Number>, InterpolationColumn<Number>,
                       InterpolationSample<Number>> &step)
{
    const InterpolationSample<Number> &sample = step.sample;
    InterpolationSampleState state{{quantitiesOf(sample.value), {}, sample.level},
                                   step.setUp.order,
                                   interpolationWalkOf<Number>(step).start,
                                   false};
    const auto corner = [&](std::size_t number) {
        return step.setUp.vertices[std::size_t(step.setUp.order[number])].position;
    };
    state.isPoint = corner(0) == corner(2);
    if (!step.setUp.zeroArea)
        state.weight = quantitiesOf(sample.weight);
    return state;
}

} // namespace pixelplumb
