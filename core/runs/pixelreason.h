// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/pixelhistory.h"

namespace pixelplumb {

/// A sample's distance from an edge, px, positive inside: along the columns or the rows, as the run
/// scans them, or along the others if the edge is parallel to these. None if the edge is a point.
struct ScanDistance {
    Quantity exact;
    SpanAxis axis = SpanAxis::Column;
};
ScanDistance scanDistance(const oracle::EdgeVerdict &edge, const ScanTrace &trace);

/// The reason of one attempt (PixelAttempt::reason), whose other members are filled in.
QString reasonOf(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                 std::int64_t y);

} // namespace pixelplumb
