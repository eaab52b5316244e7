// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/pixelhistory.h"

namespace pixelplumb {

/// A sample's distance from an edge, px, positive inside: along the columns or the rows, as the run
/// scans them, or along the others if the edge is parallel to these. None if the edge is a point.
struct ScanDistance {
    Quantity exact;
    SpanAxis axis = SpanAxis::Column;
};
ScanDistance scanDistance(const oracle::EdgeVerdict &edge, const ScanTrace &trace);

/// The index of the edge that rejects the sample most strongly.
std::size_t refusingEdge(const oracle::SampleVerdict &verdict);

/// Whether another edge may have decided in the run than in truth: its numbers round, or a variant
/// departs from the algorithm.
bool mayDecideOtherwise(const TracedScene &traced);

/// Why a triangle does not cover the sample: the edge that keeps it out, by how much, under which
/// rule; and the run's own reason where that may be another.
QString triangleRefusalText(const PixelAttempt &attempt, const TracedScene &traced);

/// "exactly on P₀P₁, and the rule …; it lies exactly on …": the edges on which the sample lies and
/// which give it to this side, or to the other; empty if it lies on none.
enum class TieSide { This, Other };
QString tiesText(const PixelAttempt &attempt, const TracedScene &traced, TieSide side);

/// " Refused: E₂ = −2 is negative.": the numbers by which the kernel refused a triangle's sample.
QString deciderText(const PixelAttempt &attempt, const TracedScene &traced);

/// Whether the bounds are exact although the run computes in floats: an interpolation's coverage
/// is.
bool hasExactBounds(const SpanRecord &span, Arithmetic arithmetic);
/// "the column's bounds 9 1/2 and 6 3/44 give no sample"; "exact bounds" where the run computes
/// others, or none.
QString boundsText(const SpanRecord &span, Arithmetic arithmetic);

} // namespace pixelplumb
