// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/differencemap.h"
#include "core/trace/scantrace.h"

#include <vector>

namespace pixelplumb {

/// The position of a run from which a pixel's outcome is decided. For a pixel that is wrong in the
/// end and that the run visited: just after the step that wrote it last, or that refused it last if
/// none wrote it. Where spans are neither columns nor rows, but steps of lines or circles: just
/// after the step that wrote it last. For all others: the end of the last span on their column or
/// row, or of the whole run if spans are neither or there is none.
class DecidedPositions {
public:
    DecidedPositions() = default;
    DecidedPositions(const ScanTrace &trace, const DifferenceMap &differences,
                     const FrameSpec &frame);

    std::size_t at(std::int64_t x, std::int64_t y) const;

private:
    /// A pixel with a position of its own.
    struct OwnPixel {
        std::int32_t y = 0;
        std::int32_t x = 0;
        std::size_t position = 0;
    };

    void decidePlaces(const ScanTrace &trace, const FrameSpec &frame);
    void decideOwnPixels(const ScanTrace &trace, const DifferenceMap &differences);
    void keepLastVisits();

    std::size_t m_end = 0;
    SpanAxis m_axis = SpanAxis::Free; ///< of all spans
    std::int64_t m_firstPlace = 0;
    std::vector<std::size_t> m_places; ///< by x − firstColumn or y − firstRow; empty where Free
    std::vector<OwnPixel> m_own; ///< ascending by (y, x)
};

} // namespace pixelplumb
