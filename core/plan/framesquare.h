// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/number/wideinteger.h"

#include <algorithm>
#include <cstdint>

namespace pixelplumb {

/// The union of the closed squares of a frame's pixels, with `unitsOfPixel` units per pixel.
class FrameSquare {
public:
    FrameSquare(const FrameView &frame, std::int64_t unitsOfPixel)
        : m_pixel(unitsOfPixel)
        , m_left(frame.firstColumn * m_pixel - m_pixel / 2)
        , m_right(frame.endColumn() * m_pixel - m_pixel / 2)
        , m_low(frame.firstRow * m_pixel - m_pixel / 2)
        , m_high(frame.endRow() * m_pixel - m_pixel / 2)
    {
    }

    /// Whether a point lies in the interior.
    template <class Point>
    bool holds(const Point &point) const
    {
        return m_left < point.x && point.x < m_right && m_low < point.y && point.y < m_high;
    }
    /// Whether a segment meets the closed square.
    template <class Point>
    bool isMetBy(const Point &a, const Point &b) const
    {
        return !isPartedFrom(a, b, [](auto most, auto from) { return most < from; });
    }
    /// Whether a segment meets the interior.
    template <class Point>
    bool isEnteredBy(const Point &a, const Point &b) const
    {
        return !isPartedFrom(a, b, [](auto most, auto from) { return most <= from; });
    }
    /// Whether a segment lies on a border between pixels, and so divides none.
    template <class Point>
    bool hasAsBorder(const Point &a, const Point &b) const
    {
        const auto isBorder = [this](std::int64_t at) { return (at - m_pixel / 2) % m_pixel == 0; };
        return (a.x == b.x && isBorder(a.x)) || (a.y == b.y && isBorder(a.y));
    }

private:
    /// Whether a side of the square, or the segment's own line, separates them.
    template <class Point, class IsBeside>
    bool isPartedFrom(const Point &a, const Point &b, const IsBeside &isBeside) const
    {
        if (isBeside(std::max(a.x, b.x), m_left) || isBeside(m_right, std::min(a.x, b.x))
            || isBeside(std::max(a.y, b.y), m_low) || isBeside(m_high, std::min(a.y, b.y)))
            return true;
        const auto sideOf = [&](std::int64_t x, std::int64_t y) {
            return Int128(b.x - a.x) * (y - a.y) - Int128(x - a.x) * (b.y - a.y);
        };
        const auto [least, most] = std::minmax({sideOf(m_left, m_low), sideOf(m_left, m_high),
                                                sideOf(m_right, m_low), sideOf(m_right, m_high)});
        return isBeside(most, Int128(0)) || isBeside(Int128(0), least);
    }

    std::int64_t m_pixel, m_left, m_right, m_low, m_high;
};

} // namespace pixelplumb
