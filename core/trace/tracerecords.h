// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/columnstate.h"
#include "core/scan/scanobserver.h"
#include "core/scan/scansettings.h"
#include "core/scan/spanaxis.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace pixelplumb {

/// Where a span lies.
struct SpanPlace {
    SpanAxis axis = SpanAxis::Column;
    /// x of a column, y of a row, px; for a free span the step's number, from 0.
    std::int64_t coordinate = 0;
    /// Which part of the primitive the span belongs to, from 0: the half of a column scan, the
    /// trapezoid of an edge walk.
    int part = 0;

    friend bool operator==(const SpanPlace &, const SpanPlace &) = default;
};

/// What is computed once per primitive, in any arithmetic.
struct SetUpRecord {
    std::size_t primitive = 0;
    std::optional<Rejection> rejection;
    /// For a sorted triangle: the indices of P0, P1, P2 in the caller's triangle.
    std::array<int, 3> order = {0, 1, 2};
    /// For a sorted triangle: the side that L₀₂ bounds; none where no edge is an upper or lower
    /// bound.
    std::optional<LongEdge> longEdge;
    bool zeroArea = false;
    std::vector<Quantity> cells; ///< by TraceNumbers::setUp
};

/// The numbers of one span, in any arithmetic.
struct SpanRecord {
    std::size_t primitive = 0;
    SpanPlace place;
    /// Where the bounds meet the column (y_B, y_T) or the row (x_L, x_R), px; none in methods that
    /// test every sample.
    Quantity lower, upper;
    /// The side that L₀₂ bounds here: that of the set-up unless rounding has moved the bounds past
    /// each other; none in methods whose bounds are not walked edges.
    std::optional<LongEdge> longEdge;
    std::int64_t firstSample = 0, endSample = 0; ///< along the span, unclipped
    std::int64_t firstDrawn = 0, endDrawn = 0; ///< along the span, clipped to the frame
    /// A step of a line or an outline passes half-way between two pixels, of which a rule picks
    /// one; of a column of an outline, that at either bound.
    bool isTie = false;
    std::vector<Quantity> cells; ///< by TraceNumbers::span

    std::int64_t drawnSamples() const { return std::max<std::int64_t>(0, endDrawn - firstDrawn); }
};

/// The numbers of one sample, in any arithmetic.
struct SampleRecord {
    std::int64_t x = 0;
    std::int64_t y = 0;
    SampleFate fate = SampleFate::Written;
    std::array<Quantity, 3> colour; ///< levels, before rounding
    std::array<std::int64_t, 3> level = {}; ///< rounded, before clamping
    bool clamped = false;
    std::vector<Quantity> cells; ///< by TraceNumbers::sample
};

} // namespace pixelplumb
