// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/levelpixel.h"
#include "core/shade/depthbuffer.h"
#include "core/shade/effectwork.h"
#include "core/shade/pixelarea.h"
#include "core/shade/shadedsample.h"

namespace pixelplumb {

/// What a triangle's samples are shaded with.
template <class N>
struct ShadedSurface {
    const Lighting<typename N::Real> *lighting = nullptr; ///< if light is carried
    const Material *material = nullptr;
    DepthBuffer<N> *depths = nullptr; ///< if depth is compared
    std::uint32_t greatestLevel = 0; ///< of the depth format
    ByteRounding rounding = ByteRounding::Nearest;
    QRgb flat = 0; ///< the colour of a triangle whose colours are equal
    const PixelArea *area = nullptr; ///< of the pixel, with area antialiasing
};

/// Up to 64 samples of one column, bottom to top: everything that the stages of a plan pass on.
/// Samples in play come first, without gaps, so that a stage is a plain loop over [0, count); a
/// refused sample is closed over and costs later stages nothing.
template <class N>
struct StagedSamples {
    using Number = typename N::Number;
    using Real = typename N::Real;
    static constexpr std::size_t capacity = 64;
    template <class Value>
    using PerSample = std::array<Value, capacity>;

    const ShadedSetUp<N> *setUp = nullptr;
    const ShadedColumn<N> *column = nullptr;
    const ShadedSurface<N> *surface = nullptr;
    const ShadedChannels *carried = nullptr; ///< from the list of stages being run
    /// One entry per row if an observer reads numbers, else null. Stages leave there what only the
    /// observer needs.
    ShadedSample<N> *read = nullptr;
    EffectCounts done = {};

    std::int64_t start = 0; ///< the row at which adding began
    std::int64_t firstRow = 0;
    std::size_t size = 0; ///< number of rows, with samples in play or refused
    QRgb *firstPixel = nullptr;
    std::ptrdiff_t stride = 0;
    PerChannel<Number> next; ///< for the run above, where channels go up by adding

    std::size_t count = 0; ///< in play
    PerSample<std::uint8_t> row; ///< above the first row, once a sample has been refused
    /// Linear in the frame; exact numbers are over the denominator. Floating numbers become the
    /// values for the effects when divided by 1/w.
    PerChannel<PerSample<Number>> value;
    PerSample<QRgb> colour; ///< R G B, opaque
    const Number *denominator = nullptr; ///< of exact numbers: one for all, or the values of 1/w
    bool isDivided = false; ///< the values of 1/w are the denominators

    /// Begins the rows from `first` on, all of them in play.
    void enter(std::int64_t first, std::size_t rows, FrameView frame)
    {
        firstRow = first;
        size = count = rows;
        firstPixel = frame.at(column->x, first);
        stride = frame.stride;
        denominator = &setUp->area;
        isDivided = false;
        if (!read)
            return;
        std::fill_n(read, rows, ShadedSample<N>{});
        for (std::size_t i = 0; i < rows; ++i)
            read[i].runFirst = start;
    }

    /// Keeps the `passing` samples that pass in play; the others are refused.
    void keep(const PerSample<std::uint32_t> &passes, std::size_t passing)
    {
        if (passing == count)
            return;
        PerSample<std::uint8_t> kept;
        for (std::size_t i = 0, end = 0; i < count; ++i) {
            kept[end] = std::uint8_t(i);
            end += passes[i];
        }
        const auto close = [&](auto &values) {
            for (std::size_t i = 0; i < passing; ++i)
                values[i] = values[kept[i]];
        };
        if (isWhole())
            row = kept;
        else
            close(row);
        for (const std::size_t channel : *carried) {
            if (channelAt(channel) != Channel::Depth) // no later stage reads it
                close(value[channel]);
        }
        count = passing;
    }

    /// Whether none has been refused.
    bool isWhole() const { return count == size; }
    std::size_t rowOf(std::size_t sample) const { return isWhole() ? sample : row[sample]; }
    /// Calls function(pixel, sample) for samples in play.
    template <class Function>
    void forEachPixel(const Function &function) const
    {
        const std::size_t end = count;
        if (!isWhole()) {
            for (std::size_t i = 0; i < end; ++i)
                function(firstPixel[std::ptrdiff_t(row[i]) * stride], i);
            return;
        }
        QRgb *pixel = firstPixel;
        for (std::size_t i = 0; i < end; ++i) {
            function(*pixel, i);
            pixel += stride;
        }
    }
    /// Only where an observer reads numbers.
    ShadedSample<N> &readOf(std::size_t sample) const { return read[rowOf(sample)]; }

    const Number &denominatorOf(std::size_t sample) const
    {
        return denominator[isDivided ? sample : 0];
    }
    const Number &valueOf(Channel channel, std::size_t sample) const
    {
        return value[indexOf(channel)][sample];
    }
    /// The levels that become the bytes of a channel.
    void setLevels(Channel channel, PerSample<std::int64_t> &levels) const
    {
        const ByteRounding rounding = surface->rounding;
        const auto &values = value[indexOf(channel)];
        const bool isCommon = setUp->isCommon[indexOf(channel)];
        for (std::size_t i = 0; i < count; ++i) {
            if constexpr (N::isExact)
                levels[i]
                    = N::level(values[i], isCommon ? setUp->area : denominatorOf(i), rounding);
            else
                levels[i] = N::level(values[i], rounding);
        }
    }
    /// A channel in units of one, for work without exact numbers.
    Real realOf(Channel channel, std::size_t sample) const
    {
        if constexpr (N::isExact)
            return N::real(valueOf(channel, sample), denominatorOf(sample)) / Real(attributeOne);
        else
            return valueOf(channel, sample);
    }
    Vector<Real> vectorOf(Channel x, Channel y, Channel z, std::size_t sample) const
    {
        return {realOf(x, sample), realOf(y, sample), realOf(z, sample)};
    }

    void worked(EffectWork work, std::size_t times)
    {
        done[std::size_t(work)] += std::int64_t(times);
    }
};

} // namespace pixelplumb
