// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/differencemap.h"
#include "core/trace/scantrace.h"

#include <vector>

namespace pixelplumb {

/// From which position of a run on it is decided what becomes of a pixel. Of a pixel that is wrong
/// in the end and that the run came to: just after the step that wrote it last, or that refused it
/// last where none wrote it. Where spans are neither columns nor rows, steps of lines or circles:
/// just after the step that wrote it last. Of all others: the end of the last span on their column
/// or row, or of the whole run where spans are neither or none is there.
class DecidedPositions {
public:
    DecidedPositions() = default;
    DecidedPositions(const ScanTrace &trace, const DifferenceMap &differences,
                     const FrameSpec &frame);

    std::size_t at(std::int64_t x, std::int64_t y) const;

private:
    /// A pixel that is decided by itself.
    struct OwnPixel {
        std::int32_t y = 0;
        std::int32_t x = 0;
        std::size_t position = 0;
    };

    void decidePlaces(const ScanTrace &trace, const FrameSpec &frame);
    void decideOwnPixels(const ScanTrace &trace, const DifferenceMap &differences);
    void keepLastVisits();

    std::size_t m_end = 0;
    SpanAxis m_axis = SpanAxis::Free; ///< what all spans are
    std::int64_t m_firstPlace = 0;
    std::vector<std::size_t> m_places; ///< by x − firstColumn or y − firstRow; empty where Free
    std::vector<OwnPixel> m_own; ///< ascending by (y, x)
};

} // namespace pixelplumb
