// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framemap.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// How many primitives write each pixel, and which samples inside the union of the triangles are
/// never written. A mesh under a watertight rule has neither gap nor overdraw.
class OverdrawMap {
public:
    OverdrawMap() = default;
    explicit OverdrawMap(const FrameSpec &spec)
        : m_pixels(spec)
    {
    }

    const FrameSpec &spec() const { return m_pixels.spec(); }
    /// Primitives that write the pixel; 0 outside the frame. Counts stop at 65535.
    int writesAt(std::int64_t x, std::int64_t y) const
    {
        return m_pixels.contains(x, y) ? m_pixels.at(x, y).writes : 0;
    }
    /// Never written, although a triangle owns it by the rule or the triangles surround it.
    bool isGapAt(std::int64_t x, std::int64_t y) const
    {
        return m_pixels.contains(x, y) && m_pixels.at(x, y).isGap;
    }

    std::int64_t writtenPixels() const { return m_written; } ///< once or more
    std::int64_t overdrawnPixels() const { return m_overdrawn; } ///< twice or more
    std::int64_t gaps() const { return m_gaps; }
    int mostWrites() const { return m_mostWrites; }

    // (x, y) must lie inside the frame.
    void addWrite(std::int64_t x, std::int64_t y);
    void setGap(std::int64_t x, std::int64_t y);

private:
    struct Pixel {
        std::uint16_t writes = 0;
        bool isGap = false;
    };

    FrameMap<Pixel> m_pixels;
    std::int64_t m_written = 0;
    std::int64_t m_overdrawn = 0;
    std::int64_t m_gaps = 0;
    int m_mostWrites = 0;
};

/// The overdraw of a finished run. Gaps are searched only among triangles, and only in runs that
/// were recorded to their end.
OverdrawMap overdrawOf(const TracedScene &traced);

/// True when the triangles surround the sample: it is inside one of them, or on edges and vertices
/// with a triangle on every side. Decided by four infinitely small displacements in opposite
/// directions, each of which must stay within some triangle.
bool isSurrounded(const std::vector<Triangle> &triangles, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
