// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shadedstate.h"
#include "core/scan/biasnumber.h"

namespace pixelplumb {

/// What the vertices have in a channel, in units of one.
inline Quantity givenValue(const Vertex &vertex, const VertexAttributes &attributes,
                           Channel channel)
{
    return Quantity::rational(channelUnits(vertex, attributes, channel),
                              isLevel(channel) || channel == Channel::Reciprocal ? 1
                                                                                 : attributeOne);
}

template <class N>
ShadedSetUpState shadedStateOf(const ShadedSetUpRead<N> &setUp)
{
    ShadedSetUpState state;
    state.order = setUp.order;
    state.effects = setUp.effects;
    for (std::size_t i = 0; i < 3; ++i) {
        state.position[i] = setUp.vertices[i].position;
        state.w[i]
            = Quantity::rational(std::max<std::int64_t>(1, setUp.attributes[i].w), attributeOne);
    }
    if (setUp.zeroArea)
        return state;
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

/// What an edge has where it meets the column: in floating numbers as it was walked, in exact ones
/// what the plane has there.
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

template <InterpolationForm Form, class N, class A>
ShadedSpanState shadedStateOf(const SpanInHand<ShadedSetUpRead<N>, BoundedColumn<N, A>> &step)
{
    const BoundedColumn<N, A> &column = step.span;
    ShadedSpanState state;
    state.primitive = step.primitive;
    state.x = column.x;
    state.half = column.half;
    state.firstRow = column.firstRow;
    state.endRow = column.endRow;
    state.firstDrawn = column.firstDrawn;
    state.endDrawn = column.endDrawn;
    state.lower = quantityOf(column.lower);
    state.upper = quantityOf(column.upper);
    if constexpr (Form == InterpolationForm::Bilinear && !N::isExact) {
        // As the channels use them; what is covered may be decided by exact ones.
        state.lower = Quantity::of(column.yBottom);
        state.upper = Quantity::of(column.yTop);
    }
    if constexpr (Form == InterpolationForm::Bilinear)
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
            shadedSetUpOf<InterpolationForm::Plane, ExactShading<Int256>>({triangle, &attributes},
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

template <InterpolationForm Form, class N, class A>
ShadedSampleState shadedStateOf(
    const SampleInHand<ShadedSetUpRead<N>, BoundedColumn<N, A>, ShadedSample<N>> &step)
{
    const ShadedSample<N> &sample = step.sample;
    const ShadedSetUpRead<N> &setUp = step.setUp;
    ShadedSampleState state;
    state.x = step.x;
    state.y = step.y;
    state.isWritten = step.fate == SampleFate::Written;
    state.effects = setUp.effects;
    state.before = unpacked(sample.before);
    state.after = unpacked(sample.after);
    state.samples = sample.samples.count;
    if (state.samples > 0) {
        state.samplesWritten = sample.samples.written;
        return state;
    }
    const ShadedQuantities<N> quantities(setUp);
    state.startsRun = step.y == sample.runFirst;
    forEachChannel(setUp.effects, [&](std::size_t channel) {
        state.linear[channel] = quantities.linear(channel, sample.value[channel]);
        if (followsPerspective(channelAt(channel)))
            state.value[channel] = quantities.value(sample, channel);
    });
    if constexpr (Form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            state.weight[i] = quantities.weight(sample.weight[i]);
    }
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
        state.firstTexel = sample.texels.first;
        state.secondTexel = sample.texels.second;
        for (std::size_t i = 0; i < 2; ++i)
            state.fraction[i] = Quantity::of(sample.texels.fraction[i]);
        state.texel = sample.texels.texel;
    }
    state.textured = sample.textured;
    if (setUp.effects.light) {
        for (std::size_t i = 0; i < 3; ++i) {
            state.normal[i] = Quantity::of(sample.light.normal[i]);
            state.lit[i] = Quantity::of(sample.light.level[i]);
        }
        for (std::size_t i = 0; i < mostLights; ++i)
            state.lights[i] = {Quantity::of(sample.light.terms[i].diffuse),
                               Quantity::of(sample.light.terms[i].highlight)};
    }
    state.source = sample.source;
    state.alpha = sample.alpha;
    state.blendedAlpha = sample.blendedAlpha;
    state.area = sample.area;
    return state;
}

} // namespace pixelplumb
