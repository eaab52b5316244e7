// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/anyarithmetic.h"
#include "core/methods/edgewalknames.h"
#include "core/methods/edgewalkstate.h"
#include "core/scan/interpolationscan.h"
#include "core/trace/currentstep.h"

/// What the tables of interpolations read: the kernel's numbers as quantities, so that one table
/// serves every arithmetic.
namespace pixelplumb {

/// A kernel's numbers in the channels that it carries; the rest are none.
template <class Number, std::size_t carried>
std::array<Quantity, channelCount> channelQuantities(const std::array<Number, carried> &numbers)
{
    std::array<Quantity, channelCount> quantities;
    for (std::size_t i = 0; i < carried; ++i)
        quantities[i] = quantityOf(numbers[i]);
    return quantities;
}

template <std::size_t channelsInAll>
ChannelVertex roomyVertex(const VertexOfChannels<channelsInAll> &vertex)
{
    ChannelVertex roomy;
    roomy.carried = vertex.carried;
    roomy.position = vertex.position;
    std::ranges::copy(vertex.channels, roomy.channels.begin());
    return roomy;
}

/// The point of the frame that a row scan has turned (rowwalk.h).
constexpr LatticePoint turnedBack(const LatticePoint &point) { return {point.y, -point.x}; }

/// Without area there is no plane and there are no weights: they are none.
struct InterpolationSetUpState : InterpolationSetUp<Quantity> {
    std::array<std::array<Quantity, 4>, channelCount> normal; ///< A B C D, [channel]
    std::array<std::array<Quantity, 4>, 3> line; ///< A B C k, [vertex]
    /// In the bilinear form: what each column adds along an edge, by SortedEdge; none where the
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
    /// Equal bounds have no change between them.
    bool hasRate() const { return walk.start.hasPlane && !(column.yBottom == column.yTop); }
};

struct InterpolationSampleState : InterpolationSample<Quantity> {
    std::array<int, 3> order = {0, 1, 2}; ///< P0, P1, P2 in the caller's triangle
    EdgeWalkStart start;
    bool isPoint = false; ///< all vertices coincide
    bool hasOneColour = false; ///< not weighted in floating numbers
};

template <InterpolationForm Form, class Number, std::size_t channelsInAll>
InterpolationSetUpState interpolationStateOf(const InterpolationSetUp<Number, channelsInAll> &setUp)
{
    InterpolationSetUpState state{
        {setUp.order, setUp.longEdge, setUp.zeroArea, {}, {}, {}}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < 3; ++i)
        state.vertices[i] = roomyVertex(setUp.vertices[i]);
    if (axisOf(Form) == SpanAxis::Row) {
        for (ChannelVertex &vertex : state.vertices)
            vertex.position = turnedBack(vertex.position);
    }
    using Corner = VertexOfChannels<channelsInAll>;
    const auto corner = [&](std::size_t number) -> const Corner & {
        return setUp.vertices[std::size_t(setUp.order[number])];
    };
    for (std::size_t edge = 0; edge < 3 && isBilinear(Form); ++edge) {
        const auto &ends = sortedEdgeEnds[edge];
        const Corner &a = corner(ends[0]);
        const Corner &b = corner(ends[1]);
        if (a.position.x == b.position.x
            || (setUp.zeroArea && edge != std::size_t(SortedEdge::L02)))
            continue;
        const ChannelEdge<Number, channelsInAll> walked(a, b, 0);
        state.slope[edge] = Quantity::of(walked.slope);
        state.rate[edge] = channelQuantities(walked.rate);
    }
    if (setUp.zeroArea)
        return state;
    for (std::size_t channel = 0; channel < setUp.carried() && Form == InterpolationForm::Plane;
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

/// Which bounds belong to a column, or a row. Under top-left that depends on a column's edges and
/// is read from the samples that it covers.
template <InterpolationForm Form, class Number, std::size_t channelsInAll>
Interval coveredBy(const InterpolationColumn<Number, channelsInAll> &column, FillRule rule)
{
    if (axisOf(Form) == SpanAxis::Row || rule != FillRule::TopLeft)
        return columnIntervals(rule).rows;
    const bool coversLower = column.firstRow == column.lower.ceil();
    const bool coversUpper = column.endRow == column.upper.floor() + 1;
    if (coversLower)
        return coversUpper ? Interval::Closed : Interval::ClosedOpen;
    return coversUpper ? Interval::OpenClosed : Interval::Open;
}

/// A column's, or a row's, walk along the edges, described as the edge walks describe theirs.
template <InterpolationForm Form, class Number, std::size_t channelsInAll>
EdgeWalkSpanState interpolationWalkOf(
    const CurrentSpan<InterpolationSetUp<Number, channelsInAll>,
                      InterpolationColumn<Number, channelsInAll>> &step)
{
    const auto &setUp = step.setUp;
    EdgeWalkSpanState walk;
    walk.primitive = step.primitive;
    for (std::size_t corner = 0; corner < 3; ++corner)
        walk.corners[corner].position = setUp.vertices[std::size_t(setUp.order[corner])].position;
    const LatticePoint p0 = walk.corners[0].position;
    const LatticePoint p2 = walk.corners[2].position;
    if (axisOf(Form) == SpanAxis::Row) {
        for (Vertex &corner : walk.corners)
            corner.position = turnedBack(corner.position);
    }
    walk.start = {!setUp.zeroArea, setUp.zeroArea && p0.x == p2.x && p0.y != p2.y,
                  step.span.firstDrawn != step.span.firstRow,
                  Quantity::of(step.span.yBottom) == Quantity::of(step.span.yTop),
                  coveredBy<Form>(step.span, step.settings.fillRule)};
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

template <InterpolationForm Form, class Number, std::size_t channelsInAll>
InterpolationSpanState interpolationStateOf(
    const CurrentSpan<InterpolationSetUp<Number, channelsInAll>,
                      InterpolationColumn<Number, channelsInAll>> &step)
{
    const InterpolationColumn<Number, channelsInAll> &column = step.span;
    return {interpolationWalkOf<Form, Number, channelsInAll>(step),
            {column.x, column.half, column.lower, column.upper, column.firstRow, column.endRow,
             column.firstDrawn, column.endDrawn, Quantity::of(column.yBottom),
             Quantity::of(column.yTop), channelQuantities(column.bottom),
             channelQuantities(column.top), channelQuantities(column.rate),
             channelQuantities(column.first)}};
}

template <InterpolationForm Form, class Number, std::size_t channelsInAll>
InterpolationSampleState interpolationStateOf(
    const CurrentSample<InterpolationSetUp<Number, channelsInAll>,
                        InterpolationColumn<Number, channelsInAll>,
                        InterpolationSample<Number, channelsInAll>> &step)
{
    const InterpolationSample<Number, channelsInAll> &sample = step.sample;
    InterpolationSampleState state{{channelQuantities(sample.value), {}, sample.level},
                                   step.setUp.order,
                                   interpolationWalkOf<Form, Number, channelsInAll>(step).start,
                                   false,
                                   pixelplumb::hasOneColour(step.setUp)};
    const auto corner = [&](std::size_t number) {
        return step.setUp.vertices[std::size_t(step.setUp.order[number])].position;
    };
    state.isPoint = corner(0) == corner(2);
    if (!step.setUp.zeroArea)
        state.weight = quantitiesOf(sample.weight);
    return state;
}

} // namespace pixelplumb
