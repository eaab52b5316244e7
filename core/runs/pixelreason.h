// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/pixelhistory.h"

namespace pixelplumb {

/// How far a sample is from an edge, px, positive inside: along the columns or the rows, as the run
/// scans them; along the others where the edge is parallel to these. None where it is a point.
struct ScanDistance {
    Quantity exact;
    SpanAxis axis = SpanAxis::Column;
};
ScanDistance scanDistance(const oracle::EdgeVerdict &edge, const ScanTrace &trace);

/// What a pixel's history says of one attempt (PixelAttempt::reason), whose other parts are there.
QString reasonOf(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                 std::int64_t y);

} // namespace pixelplumb
