// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalknames.h"
#include "core/methods/shading/shadedstate.h"
#include "core/scan/interpolation/interpolationscan.h"

#include <algorithm>

/// How the numbers of an interpolation become the states of shaded triangles: an interpolation is
/// shading without effects. A channel's place in them is its place among the carried ones.
namespace pixelplumb {

/// A kernel's numbers in the channels that it carries; the rest are none.
template <class Number, std::size_t carried>
PerChannel<Quantity> channelQuantities(const std::array<Number, carried> &numbers)
{
    PerChannel<Quantity> quantities;
    for (std::size_t i = 0; i < carried; ++i)
        quantities[i] = quantityOf(numbers[i]);
    return quantities;
}

/// The point of the frame that a row scan has turned (rowwalk.h).
constexpr LatticePoint turnedBack(const LatticePoint &point) { return {point.y, -point.x}; }

template <InterpolationForm Form, class Number, std::size_t channelsInAll>
ShadedSetUpState interpolationStateOf(const InterpolationSetUp<Number, channelsInAll> &setUp)
{
    ShadedSetUpState state;
    state.order = setUp.order;
    state.form = Form;
    state.zeroArea = setUp.zeroArea;
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &at = setUp.vertices[i].position;
        state.position[i] = axisOf(Form) == SpanAxis::Row ? turnedBack(at) : at;
        for (std::size_t channel = 0; channel < setUp.carried(); ++channel)
            state.given[channel][i]
                = Quantity::rational(setUp.vertices[i].channels[channel], unitsOfChannel(channel));
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

template <InterpolationForm Form, class Number, std::size_t channelsInAll>
EdgeWalkSpanState interpolationWalkOf(
    const CurrentSpan<InterpolationSetUp<Number, channelsInAll>,
                      InterpolationColumn<Number, channelsInAll>> &step)
{
    EdgeWalkSpanState walk = boundsOf(step, step.setUp.longEdge, step.previous);
    walk.start.isPoint = Quantity::of(step.span.yBottom) == Quantity::of(step.span.yTop);
    for (Vertex &corner : walk.corners) {
        if (axisOf(Form) == SpanAxis::Row)
            corner.position = turnedBack(corner.position);
    }
    return walk;
}

template <InterpolationForm Form, class Number, std::size_t channelsInAll>
ShadedSpanState interpolationStateOf(
    const CurrentSpan<InterpolationSetUp<Number, channelsInAll>,
                      InterpolationColumn<Number, channelsInAll>> &step)
{
    const InterpolationColumn<Number, channelsInAll> &column = step.span;
    ShadedSpanState state{interpolationWalkOf<Form, Number, channelsInAll>(step),
                          true,
                          column.firstRow,
                          column.endRow,
                          column.firstDrawn,
                          column.endDrawn,
                          Quantity::of(column.yBottom),
                          Quantity::of(column.yTop),
                          channelQuantities(column.bottom),
                          channelQuantities(column.top),
                          {}};
    if (state.hasRate())
        state.rate = channelQuantities(column.rate);
    return state;
}

template <InterpolationForm Form, class Number, std::size_t channelsInAll>
ShadedSampleState interpolationStateOf(
    const CurrentSample<InterpolationSetUp<Number, channelsInAll>,
                        InterpolationColumn<Number, channelsInAll>,
                        InterpolationSample<Number, channelsInAll>> &step)
{
    ShadedSampleState state;
    state.order = step.setUp.order;
    state.start = interpolationWalkOf<Form, Number, channelsInAll>(step).start;
    state.linear = channelQuantities(step.sample.value);
    if (pixelplumb::hasOneColour(step.setUp))
        std::fill_n(state.isCommon.begin(), colourChannelCount, true);
    if (!step.setUp.zeroArea)
        state.weight = quantitiesOf(step.sample.weight);
    return state;
}

} // namespace pixelplumb
