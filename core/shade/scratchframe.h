// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/colour.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace pixelplumb {

/// A frame with its own memory and the window of another frame.
class ScratchFrame {
public:
    explicit ScratchFrame(const FrameView &like)
        : m_pixels(std::size_t(like.width) * std::size_t(like.height))
        , m_view(like)
    {
        m_view.base = m_pixels.data();
        m_view.stride = like.width;
    }

    const FrameView &view() const { return m_view; }
    void copyFrom(const FrameView &frame)
    {
        for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y)
            std::copy_n(frame.at(frame.firstColumn, y), frame.width,
                        m_view.at(frame.firstColumn, y));
    }

private:
    std::vector<QRgb> m_pixels;
    FrameView m_view;
};

/// The mean of a pixel's samples, ⌊Σ/n + ½⌋ per channel; opaque if any sample is.
class SampleMean {
public:
    void add(QRgb pixel)
    {
        ++m_count;
        m_alpha |= pixel & 0xff000000U;
        const Colour colour = unpacked(pixel);
        for (std::size_t i = 0; i < 3; ++i)
            m_sum[i] += colour.channels[i];
    }
    QRgb pixel() const
    {
        Colour mean;
        for (std::size_t i = 0; i < 3; ++i)
            mean.channels[i] = std::uint8_t((2 * m_sum[i] + m_count) / (2 * m_count));
        return (packed(mean) & 0xffffffU) | m_alpha;
    }

private:
    std::array<unsigned, 3> m_sum = {};
    unsigned m_count = 0;
    QRgb m_alpha = 0;
};

/// The current colours of a pixel's samples, in their order: for readers of numbers. The drawing
/// keeps a SampleMean for each pixel of a frame, which has no room for them.
class PixelSamples {
public:
    void add(QRgb sample) { m_colours[m_count++] = sample; }
    /// Empty where the pixel has one sample.
    std::span<const QRgb> colours() const { return {m_colours.data(), m_count}; }

private:
    std::array<QRgb, 16> m_colours = {};
    std::size_t m_count = 0;
};

} // namespace pixelplumb
