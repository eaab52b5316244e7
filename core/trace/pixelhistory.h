// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/tracedscene.h"

#include <limits>

namespace pixelplumb {

/// What one triangle did to one pixel, and what the truth says of it.
struct PixelAttempt {
    std::size_t triangle = 0;
    oracle::SampleVerdict verdict;
    std::array<Quantity, 3> exactColour; ///< of the oracle, levels
    /// The column's numbers, where the triangle's scan entered the pixel's column.
    std::optional<ColumnRecord> column;

    bool written = false;
    std::size_t step = 0; ///< index of the step that wrote it
    PixelChange change; ///< what it wrote
    FragmentRecord fragment; ///< the numbers that it used

    /// One or two sentences: the numbers that wrote it, or the edge that refuses it, by how much,
    /// under which rule; and how that differs from the truth, where it does.
    QString reason;
};

/// The attempts of all triangles on a pixel, in drawing order. Of the triangles that rightly leave
/// it alone only the first `explainedRefusals` get a reason and exact colours: a scene may hold
/// thousands, and a view lists a few.
std::vector<PixelAttempt> pixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y,
                                       std::size_t explainedRefusals
                                       = std::numeric_limits<std::size_t>::max());

} // namespace pixelplumb
