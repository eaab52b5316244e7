// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalknames.h"
#include "core/methods/shading/shadedstate.h"
#include "core/scan/biasnumber.h"

#include <algorithm>

namespace pixelplumb {

/// A vertex's value in a channel, in units of one.
inline Quantity givenValue(const Vertex &vertex, const VertexAttributes &attributes,
                           Channel channel)
{
    return Quantity::rational(channelUnits(vertex, attributes, channel),
                              isLevel(channel) || channel == Channel::Reciprocal ? 1
                                                                                 : attributeOne);
}

/// Sets what each column adds along the edges: to y, as it is walked, and in the bilinear form to
/// the channels; exact rates are those of the channel's plane along the edge.
template <class N, class A>
void setSlopes(const ShadedSetUpRead<N> &setUp, ShadedSetUpState &state)
{
    const ShadedQuantities<N> quantities(setUp);
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const auto from = std::size_t(setUp.order[sortedEdgeEnds[edge][0]]);
        const auto to = std::size_t(setUp.order[sortedEdgeEnds[edge][1]]);
        const ShadedCorner<N> &a = setUp.vertices[from];
        const ShadedCorner<N> &b = setUp.vertices[to];
        const Lattice run = b.position.x - a.position.x;
        if (run == 0)
            continue;
        state.slope[edge] = quantityOf(A::edgeSlope(setUp.corners[from], setUp.corners[to]));
        if (setUp.form != InterpolationForm::Bilinear)
            continue;
        if constexpr (N::isExact) {
            for (const std::size_t channel : setUp.carried)
                state.rate[edge][channel]
                    = quantities.rate(channel, b.channels[channel] - a.channels[channel], run);
        } else {
            const ShadedEdge<N> walked(a, b, 0, setUp.carried);
            state.slope[edge] = Quantity::of(walked.slope);
            for (const std::size_t channel : setUp.carried)
                state.rate[edge][channel] = Quantity::of(walked.rate[channel]);
        }
    }
}

template <class N, class A>
ShadedSetUpState shadedStateOf(const ShadedSetUpRead<N> &setUp)
{
    ShadedSetUpState state;
    state.order = setUp.order;
    state.form = setUp.form;
    state.effects = setUp.effects;
    state.isDivided = dividedChannelsOf(setUp);
    state.zeroArea = setUp.zeroArea;
    state.material = setUp.material;
    for (std::size_t i = 0; i < 3; ++i) {
        state.position[i] = setUp.vertices[i].position;
        state.w[i]
            = Quantity::rational(std::max<std::int64_t>(1, setUp.attributes[i].w), attributeOne);
    }
    setSlopes<N, A>(setUp, state);
    const ShadedQuantities<N> quantities(setUp);
    forEachChannel(setUp.effects, [&](std::size_t channel) {
        for (std::size_t i = 0; i < 3; ++i) {
            state.given[channel][i]
                = givenValue(setUp.corners[i], setUp.attributes[i], channelAt(channel));
            state.linear[channel][i]
                = quantities.vertex(channel, setUp.vertices[i].channels[channel]);
            state.plane[channel][i] = quantities.linear(channel, setUp.plane[channel][i]);
        }
    });
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            state.weight[i][k] = quantities.weight(setUp.weight[i][k]);
    }
    return state;
}

/// Sets an edge's values where it meets the column: as walked; in exact numbers as of the plane.
template <class N, class A>
void setBounds(const ShadedSetUpRead<N> &setUp, const BoundedColumn<N, A> &column,
               const ShadedQuantities<N> &quantities, ShadedSpanState &state)
{
    forEachChannel(setUp.effects, [&](std::size_t channel) {
        state.rate[channel] = quantities.linear(channel, column.rate[channel]);
        if constexpr (!N::isExact) {
            state.bottom[channel] = Quantity::of(column.bottom[channel]);
            state.top[channel] = Quantity::of(column.top[channel]);
        } else {
            const auto at = [&](const Quantity &y) {
                // linear(atRow0 + rate·y), with y a fraction.
                const Quantity base = quantities.linear(channel, column.atRow0[channel]);
                const Quantity &rate = state.rate[channel];
                if (!base.isRational() || !rate.isRational())
                    return Quantity();
                return quotientOf(
                    BigInteger(base.numerator()) * rate.denominator() * y.denominator()
                        + BigInteger(rate.numerator()) * y.numerator() * base.denominator(),
                    BigInteger(base.denominator()) * rate.denominator() * y.denominator());
            };
            state.bottom[channel] = at(state.lower);
            state.top[channel] = at(state.upper);
        }
    });
}

/// A column's walk along the edges, described as the edge walks describe theirs. In forms that are
/// not bilinear digits name the vertices in the order given.
template <class N, class A>
EdgeWalkSpanState shadedWalkOf(const CurrentSpan<ShadedSetUpRead<N>, BoundedColumn<N, A>> &step)
{
    const BoundedColumn<N, A> *before = step.previous
            && step.previous->origin == ColumnOrigin::Walked
            && step.span.origin == ColumnOrigin::Walked
        ? step.previous
        : nullptr;
    EdgeWalkSpanState walk = boundsOf(step, step.span.longEdge, before);
    for (std::size_t i = 0; i < 3; ++i) {
        if (step.setUp.form != InterpolationForm::Bilinear)
            walk.digits[i] = std::size_t(step.setUp.order[i]);
    }
    walk.isCrossed = before && before->longEdge != step.span.longEdge;
    return walk;
}

template <class N, class A>
ShadedSpanState shadedStateOf(const CurrentSpan<ShadedSetUpRead<N>, BoundedColumn<N, A>> &step)
{
    const BoundedColumn<N, A> &column = step.span;
    ShadedSpanState state;
    state.walk = shadedWalkOf(step);
    state.isBounded = column.origin != ColumnOrigin::None;
    if (!state.isBounded)
        return state;
    state.firstRow = column.firstRow;
    state.endRow = column.endRow;
    state.firstDrawn = column.firstDrawn;
    state.endDrawn = column.endDrawn;
    state.lower = quantityOf(column.lower);
    state.upper = quantityOf(column.upper);
    if (step.setUp.form != InterpolationForm::Bilinear)
        return state;
    if constexpr (!N::isExact) {
        // As the channels use them; coverage may be decided by exact ones.
        state.lower = Quantity::of(column.yBottom);
        state.upper = Quantity::of(column.yTop);
    }
    setBounds(step.setUp, column, ShadedQuantities<N>(step.setUp), state);
    return state;
}

/// u and v as if all w were equal: what an affine texture would show here.
template <class N>
std::array<Quantity, 2> affineTexture(const ShadedSetUpRead<N> &setUp, std::int64_t x,
                                      std::int64_t y)
{
    const ShadedSetUpRead<ExactShading<Int256>> affine = [&] {
        const Triangle triangle{setUp.corners};
        const TriangleAttributes attributes{0, setUp.attributes, noMaterial};
        EffectSet texture;
        texture.texture = true;
        return ShadedSetUpRead<ExactShading<Int256>>{
            shadedSetUpOf<ExactShading<Int256>>(InterpolationForm::Plane, {triangle, &attributes},
                                                texture),
            setUp.corners, setUp.attributes, noMaterial};
    }();
    const ShadedQuantities<ExactShading<Int256>> quantities(affine);
    std::array<Quantity, 2> texture;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t channel = indexOf(Channel::U) + i;
        const auto &plane = affine.plane[channel];
        texture[i] = quantities.linear(channel, Int256(plane[0] * x + plane[1] * y + plane[2]));
    }
    return texture;
}

/// How far the sample lies from a texel's centre to the next one's: exactly, if its position is
/// exact.
inline Quantity texelFraction(const ShadedSampleState &state, std::size_t side,
                              const Quantity &used)
{
    const Quantity &place = state.interpolatedIn(indexOf(Channel::U) + side);
    if (!place.isRational())
        return used;
    const BigInteger below = 2 * BigInteger(place.denominator());
    const BigInteger twice = 2 * BigInteger(state.textureSize[side]) * BigInteger(place.numerator())
        - BigInteger(place.denominator());
    const BigInteger rest = twice % below;
    return quotientOf(rest < 0 ? BigInteger(rest + below) : rest, below);
}

/// With area coverage, an opaque sample inside a triangle is not blended and has no alpha.
template <class N>
bool isBlended(const ShadedSetUpRead<N> &setUp, const ShadedSample<N> &sample)
{
    const bool isOpaque = std::ranges::all_of(
        setUp.attributes, [](const VertexAttributes &vertex) { return vertex.alpha == 255; });
    const bool hasAlpha = sample.value[indexOf(Channel::Alpha)] != typename N::Number(0);
    return setUp.effects.blending && (hasAlpha || !isOpaque);
}

template <class N, class A>
ShadedSampleState shadedStateOf(
    const CurrentSample<ShadedSetUpRead<N>, BoundedColumn<N, A>, ShadedSample<N>> &step)
{
    const ShadedSample<N> &sample = step.sample;
    const ShadedSetUpRead<N> &setUp = step.setUp;
    ShadedSampleState state;
    state.x = step.x;
    state.y = step.y;
    state.isWritten = step.fate == SampleFate::Written;
    state.effects = setUp.effects;
    state.isCommon = setUp.isCommon;
    state.isDivided = dividedChannelsOf(setUp);
    state.commonVertex = setUp.commonVertex();
    state.before = unpacked(sample.before);
    state.after = unpacked(sample.after);
    state.pixelSamples = sample.samples.current;
    if (state.samples() > 0) {
        state.samplesWritten = sample.samples.written;
        return state;
    }
    const ShadedQuantities<N> quantities(setUp);
    state.startsRun = step.y == sample.runFirst;
    state.isBlended = isBlended(setUp, sample);
    forEachChannel(setUp.effects, [&](std::size_t channel) {
        if (channelAt(channel) == Channel::Alpha && !state.isBlended)
            return;
        state.linear[channel] = quantities.linear(channel, sample.value[channel]);
        if (followsPerspective(channelAt(channel)))
            state.value[channel] = quantities.value(sample, channel);
    });
    if (setUp.form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            state.weight[i] = quantities.weight(sample.weight[i]);
    }
    state.isBeyondHorizon = setUp.effects.perspective
        && sample.value[indexOf(Channel::Reciprocal)] <= typename N::Number(0);
    if (state.isBeyondHorizon)
        return state; // nothing else was computed
    if (setUp.effects.depth == DepthTest::Number) {
        state.depth = quantities.depth(sample.depth.now);
        state.nearest = quantities.depth(sample.depth.before);
    } else if (setUp.effects.depth == DepthTest::Levels) {
        state.depth = Quantity::integer(sample.depth.levelNow);
        if (sample.depth.levelBefore != std::numeric_limits<std::uint32_t>::max())
            state.nearest = Quantity::integer(sample.depth.levelBefore);
    }
    if (setUp.effects.texture && setUp.effects.perspective)
        state.affine = affineTexture(setUp, step.x, step.y);
    if (!state.isWritten)
        return state;
    state.interpolated = sample.interpolated;
    if (setUp.effects.texture) {
        state.textureSize = sample.texels.size;
        state.wrap = sample.texels.wrap;
        state.firstTexel = sample.texels.first;
        state.isFiltered = sample.texels.isFiltered;
        state.texels = sample.texels.four;
        for (std::size_t i = 0; i < 2; ++i)
            state.fraction[i] = texelFraction(state, i, Quantity::of(sample.texels.fraction[i]));
        state.texel = sample.texels.texel;
    }
    state.textured = sample.textured;
    if (setUp.effects.light) {
        for (std::size_t i = 0; i < 3; ++i) {
            state.normal[i] = Quantity::of(sample.light.normal[i]);
            state.toViewer[i] = Quantity::of(sample.light.toViewer[i]);
            state.lit[i] = Quantity::of(sample.light.level[i]);
        }
        state.normalLength = Quantity::of(lengthOf(sample.light.carried));
        for (std::size_t i = 0; i < mostLights; ++i)
            state.lights[i] = lightStateOf(sample.light.terms[i]);
    }
    state.source = sample.source;
    state.alpha = sample.alpha;
    state.blendedAlpha = sample.blendedAlpha;
    state.area = sample.area;
    return state;
}

} // namespace pixelplumb
