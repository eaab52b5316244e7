// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"
#include "core/scan/spanaxis.h"

#include <functional>
#include <vector>

namespace pixelplumb {

/// Some spans of a frame, ascending: x of columns, or y of rows where the axis is another. Their
/// picture has them side by side, or one row below the other.
class ChosenSpans {
public:
    /// At least one.
    ChosenSpans(SpanAxis axis, std::vector<std::int64_t> spans);

    SpanAxis axis() const { return m_axis; }
    const std::vector<std::int64_t> &spans() const { return m_spans; }
    bool areColumns() const { return m_axis == SpanAxis::Column; }
    bool contains(std::int64_t span) const
    {
        return span >= m_spans.front() && span <= m_spans.back()
            && m_places[std::size_t(span - m_spans.front())] != notChosen;
    }
    /// Its place among them; only of one that is chosen.
    std::size_t placeOf(std::int64_t span) const
    {
        return m_places[std::size_t(span - m_spans.front())];
    }

private:
    static constexpr std::uint32_t notChosen = ~0U;

    SpanAxis m_axis;
    std::vector<std::int64_t> m_spans;
    std::vector<std::uint32_t> m_places; ///< from the first of them to the last
};

/// The frame of one of these spans; the off-screen point stays where it is.
FrameSpec partOf(const FrameSpec &frame, SpanAxis axis, std::int64_t span);
/// Calls visit(x, line, place) for all pixels of these spans: where each is in a picture of the
/// whole frame, and in that of the spans.
void forEachPlace(const ChosenSpans &chosen, const FrameSpec &frame,
                  const std::function<void(int x, int line, std::size_t place)> &visit);
/// These spans of a picture of the whole frame.
Picture partOf(const Picture &picture, const FrameSpec &frame, const ChosenSpans &chosen);
/// Puts the picture of these spans into one of the whole frame.
void copyTo(Picture &picture, const FrameSpec &frame, const ChosenSpans &chosen,
            const Picture &part);
/// All background.
Picture emptyPicture(const FrameSpec &frame, const ChosenSpans &chosen);
/// What the scene's method draws there. Numbers that round are stepped from the frame's first span
/// on, and may differ.
Picture pictureOf(const Scene &scene, const ChosenSpans &chosen);

} // namespace pixelplumb
