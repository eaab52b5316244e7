// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/depthbuffer.h"
#include "core/effects/effectwork.h"
#include "core/effects/pixelarea.h"
#include "core/effects/shadedsample.h"
#include "core/frame/levelpixel.h"
#include "core/scan/scanobserver.h"
#include "core/space/materialcolour.h"

/// What happens at the samples of a column, bottom to top: each stage is there where the effects
/// call for it.
namespace pixelplumb {

/// What the samples of one triangle are shaded with.
template <class N>
struct ShadedSurface {
    const Lighting<typename N::Real> *lighting = nullptr; ///< where light is carried
    const Material *material = nullptr;
    DepthBuffer<N> *depths = nullptr; ///< where depth is compared
    std::uint32_t greatestLevel = 0; ///< of the depth format
    ByteRounding rounding = ByteRounding::Nearest;
    Colour flat; ///< of a triangle whose colours are equal
    const PixelArea *area = nullptr; ///< of the pixel, where areas are covered
};

/// The rows [first, end) of a column.
struct RowRun {
    std::int64_t first = 0;
    std::int64_t end = 0;
};

template <InterpolationForm Form, class N, class Effects, class Observer>
class SampleShader {
public:
    using Sample = ShadedSample<N>;
    using Number = typename N::Number;

    SampleShader(const ShadedSetUp<N> &setUp, const ShadedColumn<N> &column, const Effects &effects,
                 const ShadedSurface<N> &surface, Observer observer)
        : m_setUp(setUp)
        , m_column(column)
        , m_effects(effects)
        , m_surface(surface)
        , m_observer(observer)
    {
    }

    [[gnu::always_inline]] void shade(const RowRun &run, FrameView frame)
    {
        if (run.first >= run.end)
            return;
        Sample sample;
        if constexpr (readsNumbers<Observer>) {
            sample = {};
            sample.runFirst = run.first;
        }
        start(run.first, sample);
        QRgb *pixel = frame.at(m_column.x, run.first);
        typename N::Depth *numbers = nullptr;
        std::uint32_t *levels = nullptr;
        if (m_effects.depth == DepthTest::Number)
            numbers = m_surface.depths->numbersAt(m_column.x, run.first);
        else if (m_effects.depth == DepthTest::Levels)
            levels = m_surface.depths->levelsAt(m_column.x, run.first);
        for (std::int64_t y = run.first; y < run.end; ++y) {
            if constexpr (!isAdding)
                evaluate(y, sample);
            const bool passes = !isBeyondHorizon(sample)
                && (m_effects.depth == DepthTest::None
                    || (m_effects.depth == DepthTest::Number ? comesNearer(numbers, sample)
                                                             : comesNearer(levels, sample)));
            if (passes)
                write(y, pixel, sample);
            else
                m_observer.sampleRejected(m_column.x, y, *pixel, sample);
            pixel += frame.stride;
            if (m_effects.depth == DepthTest::Number)
                ++numbers;
            else if (m_effects.depth == DepthTest::Levels)
                ++levels;
            if constexpr (isAdding)
                step(sample);
        }
    }

private:
    /// Whether channels go from row to row by adding.
    static constexpr bool isAdding = Form == InterpolationForm::Bilinear;

    void worked([[maybe_unused]] EffectWork work)
    {
        if constexpr (HearsEffectWork<Observer>)
            m_observer.worked(work);
    }

    [[gnu::always_inline]] void start(std::int64_t row, Sample &sample)
    {
        if constexpr (N::isExact) {
            sample.denominator = m_setUp.area;
            if constexpr (isAdding)
                forEachChannel(m_effects, [&](std::size_t channel) {
                    sample.value[channel]
                        = m_column.atRow0[channel] + Number(row) * m_column.rate[channel];
                });
        } else if constexpr (isAdding) {
            forEachChannel(m_effects, [&](std::size_t channel) {
                sample.value[channel] = m_column.bottom[channel]
                    + (Number(row) - m_column.yBottom) * m_column.rate[channel];
            });
        }
    }

    [[gnu::always_inline]] void step(Sample &sample)
    {
        forEachChannel(m_effects, [&](std::size_t channel) {
            sample.value[channel] = sample.value[channel] + m_column.rate[channel];
        });
    }

    [[gnu::always_inline]] void evaluate(std::int64_t y, Sample &sample)
    {
        const auto formAt = [&](const std::array<Number, 3> &form) -> Number {
            return form[0] * Number(m_column.x) + form[1] * Number(y) + form[2];
        };
        if constexpr (Form == InterpolationForm::Barycentric) {
            for (std::size_t i = 0; i < 3; ++i)
                sample.weight[i] = formAt(m_setUp.weight[i]);
            forEachChannel(m_effects, [&](std::size_t channel) {
                const auto &corner = m_setUp.vertices;
                sample.value[channel] = sample.weight[0] * corner[0].channels[channel]
                    + sample.weight[1] * corner[1].channels[channel]
                    + sample.weight[2] * corner[2].channels[channel];
            });
        } else {
            forEachChannel(m_effects, [&](std::size_t channel) {
                sample.value[channel] = formAt(m_setUp.plane[channel]);
            });
        }
    }

    [[gnu::always_inline]] bool comesNearer(typename N::Depth *stored, Sample &sample)
    {
        worked(EffectWork::DepthRead);
        DepthVerdict<N> &verdict = sample.depth;
        verdict.before = *stored;
        const Number &value = sample.value[indexOf(Channel::Depth)];
        if constexpr (N::isExact)
            verdict.now = N::depth(value, m_setUp.area);
        else
            verdict.now = value;
        verdict.passed = verdict.now <= verdict.before;
        if (verdict.passed) {
            *stored = verdict.now;
            worked(EffectWork::DepthWrite);
        }
        return verdict.passed;
    }

    [[gnu::always_inline]] bool comesNearer(std::uint32_t *stored, Sample &sample)
    {
        worked(EffectWork::DepthRead);
        DepthVerdict<N> &verdict = sample.depth;
        verdict.levelBefore = *stored;
        const Number &value = sample.value[indexOf(Channel::Depth)];
        if constexpr (N::isExact)
            verdict.levelNow = N::depthLevel(value, m_setUp.area, m_surface.greatestLevel);
        else
            verdict.levelNow = N::depthLevel(value, m_surface.greatestLevel);
        verdict.passed = verdict.levelNow <= verdict.levelBefore;
        if (verdict.passed) {
            *stored = verdict.levelNow;
            worked(EffectWork::DepthWrite);
        }
        return verdict.passed;
    }

    /// What a channel has at the sample, in floating numbers.
    Number quotient(const Sample &sample, Channel channel) const
    {
        const Number &value = sample.value[indexOf(channel)];
        return m_effects.perspective ? value / sample.denominator : value;
    }

    std::int64_t levelOf(const Sample &sample, Channel channel) const
    {
        if constexpr (N::isExact)
            return N::level(sample.value[indexOf(channel)], sample.denominator, m_surface.rounding);
        else
            return N::level(quotient(sample, channel), m_surface.rounding);
    }

    /// A channel in units of one, as what has no exact number reads it.
    typename N::Real realOf(const Sample &sample, Channel channel) const
    {
        if constexpr (N::isExact)
            return N::real(sample.value[indexOf(channel)], sample.denominator) /
                typename N::Real(attributeOne);
        else
            return quotient(sample, channel);
    }

    /// Beyond the horizon of its plane a sample has no attributes. Only areas reach so far.
    bool isBeyondHorizon(const Sample &sample) const
    {
        return m_surface.area && m_effects.perspective
            && !(sample.value[indexOf(Channel::Reciprocal)] > 0);
    }

    [[gnu::always_inline]] void write(std::int64_t y, QRgb *pixel, Sample &sample)
    {
        worked(EffectWork::Sample);
        if (m_effects.perspective) {
            sample.denominator = sample.value[indexOf(Channel::Reciprocal)];
            worked(EffectWork::Division);
        }
        sample.source = m_surface.flat;
        if (m_effects.smooth) {
            for (std::size_t i = 0; i < 3; ++i) {
                sample.level[i] = levelOf(sample, channelAt(i));
                sample.source.channels[i] = std::uint8_t(clampedByte(sample.level[i]));
            }
        } else if constexpr (readsNumbers<Observer>) {
            for (std::size_t i = 0; i < 3; ++i)
                sample.level[i] = m_surface.flat.channels[i];
        }
        sample.interpolated = sample.source;
        if (m_effects.texture)
            readTexture(sample);
        sample.textured = sample.source;
        if (m_effects.light)
            light(sample);
        sample.before = *pixel;
        sample.after = packed(sample.source);
        if (m_effects.blending) {
            worked(EffectWork::Blend);
            sample.alphaLevel = levelOf(sample, Channel::Alpha);
            sample.alpha = std::uint8_t(clampedByte(sample.alphaLevel));
            sample.blendedAlpha
                = m_surface.area ? m_surface.area->times(sample.alpha) : sample.alpha;
            if constexpr (readsNumbers<Observer>)
                sample.area = m_surface.area ? m_surface.area->exact() : Quantity();
            sample.after = blended(sample.source, sample.before, sample.blendedAlpha);
        }
        m_observer.pixelWritten(m_column.x, y, sample.before, sample.after, sample);
        *pixel = sample.after;
    }

    void readTexture(Sample &sample)
    {
        const auto count = [this] { worked(EffectWork::TexelFetch); };
        const auto fetch = [&](const Number &u, const Number &v) {
            // In memory its bytes would be read in other words than they were stored in.
            const TexelSample<N> texels
                = fetchTexels<N>(*m_surface.material, u, v, sample.denominator, count);
            sample.source = tinted(sample.source, texels.texel);
            if constexpr (readsNumbers<Observer>)
                sample.texels = texels;
        };
        if constexpr (N::isExact)
            fetch(sample.value[indexOf(Channel::U)], sample.value[indexOf(Channel::V)]);
        else
            fetch(quotient(sample, Channel::U), quotient(sample, Channel::V));
    }

    void light(Sample &sample)
    {
        using Real = typename N::Real;
        worked(EffectWork::Normal);
        sample.light.place = {realOf(sample, Channel::PlaceX), realOf(sample, Channel::PlaceY),
                              realOf(sample, Channel::PlaceZ)};
        const Vector<Real> normal
            = {realOf(sample, Channel::NormalX), realOf(sample, Channel::NormalY),
               realOf(sample, Channel::NormalZ)};
        lightSample(*m_surface.lighting, *m_surface.material, sample.source, normal, sample.light);
        sample.source = sample.light.colour;
    }

    const ShadedSetUp<N> &m_setUp;
    const ShadedColumn<N> &m_column;
    const Effects m_effects;
    const ShadedSurface<N> m_surface;
    Observer m_observer;
};

/// Shades the rows of a column.
template <InterpolationForm Form, class N, class Effects, class Observer>
void shadeColumn(const ShadedSetUp<N> &setUp, const ShadedColumn<N> &column, const RowRun &run,
                 const Effects &effects, const ShadedSurface<N> &surface, FrameView frame,
                 Observer observer)
{
    SampleShader<Form, N, Effects, Observer>(setUp, column, effects, surface, observer)
        .shade(run, frame);
}

} // namespace pixelplumb
