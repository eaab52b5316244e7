// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/geometry/shape.h"
#include "core/scan/columnstate.h"
#include "core/scan/workstage.h"

/// What all line methods share. A line is walked along its longer side, one pixel a step: column by
/// column, or row by row where it is steep. The methods compute with a line whose x and y are
/// exchanged where it is steep, so that "along" is always x.
namespace pixelplumb {

/// Which coordinate changes by one at each step of a line.
enum class LineAxis : std::uint8_t { X, Y };

/// Rasterization slides, "DDA Line-Drawing Algorithm": "check if |m| < 1, iterate along x,
/// otherwise iterate along y".
constexpr LineAxis lineAxisOf(const LatticePoint &a, const LatticePoint &b)
{
    return absolute(b.y - a.y) < absolute(b.x - a.x) ? LineAxis::X : LineAxis::Y;
}

constexpr Vertex exchanged(Vertex vertex, LineAxis axis)
{
    if (axis == LineAxis::Y)
        std::swap(vertex.position.x, vertex.position.y);
    return vertex;
}

/// A range of steps: of the frame's columns, or of its rows for the axis Y.
struct StepRange {
    std::int64_t first = 0;
    std::int64_t end = 0; ///< one past the last

    bool isEmpty() const { return first >= end; }
    constexpr StepRange clippedTo(const StepRange &other) const
    {
        return {std::max(first, other.first), std::min(end, other.end)};
    }
    /// The frame's extent along a line of this axis, and across it.
    static constexpr StepRange along(FrameView frame, LineAxis axis)
    {
        return axis == LineAxis::X ? StepRange{frame.firstColumn, frame.endColumn()}
                                   : StepRange{frame.firstRow, frame.endRow()};
    }
    static constexpr StepRange across(FrameView frame, LineAxis axis)
    {
        return along(frame, axis == LineAxis::X ? LineAxis::Y : LineAxis::X);
    }
};

/// Where the pixel of a step is.
struct LinePlace {
    LineAxis axis = LineAxis::X;
    std::int64_t along = 0; ///< px
    std::int64_t across = 0; ///< px
    bool isInFrame = false; ///< set by findIn()

    void findIn(FrameView frame) { isInFrame = frame.contains(x(), y()); }
    std::int64_t x() const { return axis == LineAxis::X ? along : across; }
    std::int64_t y() const { return axis == LineAxis::X ? across : along; }
};

/// Writes the pixel of a step if the frame holds it.
template <class A, class Observer>
void plot(const LinePlace &place, const std::array<typename A::Number, 3> &colour,
          ByteRounding rounding, FrameView frame, Observer observer)
{
    if (!place.isInFrame)
        return;
    [[maybe_unused]] const WorkScope pixels(observer, WorkStage::Pixel);
    Fragment<A> fragment;
    fragment.colour = colour;
    for (std::size_t channel = 0; channel < 3; ++channel)
        fragment.level[channel] = A::level(colour[channel], rounding);
    QRgb *pixel = frame.at(place.x(), place.y());
    const QRgb after = pixelOfLevels(fragment.level);
    observer.pixelWritten(place.x(), place.y(), *pixel, after, fragment);
    *pixel = after;
}

} // namespace pixelplumb
