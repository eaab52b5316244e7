// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/trianglebatch.h"

namespace pixelplumb {

/// One edge as a line over the columns (or rows): ⌈constant + slope · n⌉ bounds the span of column
/// n, as its first row or as the row after its last.
struct BoundingLine {
    double constant = 0;
    double slope = 0;
};

/// The edges that bound the spans of a triangle: a span begins at the larger of the two lower
/// bounds and ends before the smaller of the upper ones.
///
/// This is the assignment's ⌈y_B⌉ … ⌊y_T⌋ without a rounding error (resources/numerics.md, 3.2): y
/// is a multiple of 1/D, D = 256·ΔX. Where the boundary belongs to the span, ⌈y − 1/(2D)⌉ = ⌈y⌉
/// begins it and ⌈y + 1/(2D)⌉ = ⌊y⌋ + 1 ends it; where it does not, the signs are exchanged. All
/// four allow an error below 1/(2D). Here the constant is (Ya·ΔX − Xa·ΔY ± 1/2)/256 · (1/ΔX) with a
/// numerator below 2^49 that double holds exactly, so |constant| <= 2^40/ΔX; |slope · n| = |ΔY ·
/// (1/ΔX) · n| <= 2^39/ΔX. The reciprocal, each product and the sum have a relative error of 2^-53:
/// in all at most 2^-53·(3·2^40 + 4·2^39)/ΔX < 2^-10/ΔX, half of 1/(2D) = 2^-9/ΔX.
struct BoundingLines {
    std::array<BoundingLine, 2> lower; ///< the same line twice where there is only one
    std::array<BoundingLine, 2> upper;

    BoundingLines(const TriangleBatch &batch, std::size_t i)
        : lower{line(batch, i, 0), line(batch, i, 1)}
        , upper{line(batch, i, 2), line(batch, i, 3)}
    {
    }

private:
    static BoundingLine line(const TriangleBatch &batch, std::size_t i, std::size_t which)
    {
        return {batch.lineConstant[which][i], batch.lineSlope[which][i]};
    }
};

} // namespace pixelplumb
