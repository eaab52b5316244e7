// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/scan/tests/edgeteststate.h"

#include <algorithm>
#include <vector>

namespace pixelplumb {

/// The samples of a frame around a triangle, up to `margin` px beyond its bounding box.
inline SampleBox windowAround(const Triangle &triangle, std::int64_t margin, const FrameView &frame)
{
    const SampleBox box = boundingBoxOf(triangle);
    return intersection(
        {box.firstX - margin, box.endX + margin, box.firstY - margin, box.endY + margin},
        samplesOf(frame));
}

/// A transparent piece of a frame with memory of its own, for pictures of single triangles.
class PixelWindow {
public:
    /// `frame` says which way y points and where the off-screen point is.
    PixelWindow(const SampleBox &box, const FrameView &frame)
        : m_view(frame)
    {
        m_view.firstColumn = std::int32_t(box.firstX);
        m_view.firstRow = std::int32_t(box.firstY);
        m_view.width = std::int32_t(std::max<std::int64_t>(0, box.endX - box.firstX));
        m_view.height = std::int32_t(std::max<std::int64_t>(0, box.endY - box.firstY));
        m_view.stride = m_view.width;
        m_pixels.assign(std::size_t(m_view.width) * std::size_t(m_view.height), 0);
        m_view.base = m_pixels.data();
    }
    PixelWindow(PixelWindow &&) = default;
    PixelWindow &operator=(PixelWindow &&) = default;
    PixelWindow(const PixelWindow &) = delete;
    PixelWindow &operator=(const PixelWindow &) = delete;
    ~PixelWindow() = default;

    bool isEmpty() const { return m_pixels.empty(); }
    FrameView view() const { return m_view; }
    const std::vector<QRgb> &pixels() const { return m_pixels; }
    void clear() { std::ranges::fill(m_pixels, 0U); }

private:
    std::vector<QRgb> m_pixels;
    FrameView m_view;
};

} // namespace pixelplumb
