// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/trace/tracerecords.h"

namespace pixelplumb {

/// The pixels of one span, in which a kernel's loop is run again: their colours do not matter.
class SpanPixels {
public:
    /// The span's pixels from `first` up to, but not including, `end`.
    SpanPixels(const SpanPlace &place, std::int64_t first, std::int64_t end)
        : m_pixels(std::size_t(std::max<std::int64_t>(end - first, 0)), QRgb(0))
    {
        const auto count = std::int32_t(m_pixels.size());
        const auto across = std::int32_t(place.coordinate);
        const auto along = std::int32_t(first);
        m_view = place.axis == SpanAxis::Row
            ? FrameView{m_pixels.data(), count, along, across, count, 1}
            : FrameView{m_pixels.data(), 1, across, along, 1, count};
    }
    SpanPixels(const SpanPixels &) = delete;
    SpanPixels &operator=(const SpanPixels &) = delete;

    bool isEmpty() const { return m_pixels.empty(); }
    FrameView view() const { return m_view; }

private:
    std::vector<QRgb> m_pixels;
    FrameView m_view;
};

} // namespace pixelplumb
