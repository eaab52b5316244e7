// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/scan/scansettings.h"

#include <array>
#include <cstdint>

namespace pixelplumb {

/// Which pair of edges bounds a column: L₀₁ with L₀₂ up to x₁, then L₁₂ with L₀₂.
enum class ColumnHalf { First, Second };

/// The three edges of the triangle P0 P1 P2, sorted by x.
enum class SortedEdge { L01, L12, L02 };

/// Which side of the triangle the long edge L₀₂ bounds.
enum class LongEdge { Above, Below };

/// Which columns a triangle has, and which way it lies.
struct ColumnRange {
    std::array<int, 3> order = {}; ///< indices of P0, P1, P2 in the caller's triangle
    LongEdge longEdge = LongEdge::Above;
    bool zeroArea = false;
    std::int64_t firstColumn = 0; ///< ⌈x₀⌉, or ⌊x₀⌋ + 1 where x₀ itself is not scanned
    std::int64_t middleColumn = 0; ///< ⌈x₁⌉: the first column of the second half
    std::int64_t endColumn = 0; ///< one past the last column
};

/// Everything that is computed once for a triangle.
template <class A>
struct ColumnSetUp : ColumnRange {
    std::array<typename A::Number, 3> slope
        = {}; ///< px per column, by SortedEdge; 0 for a vertical edge
    /// Levels per column, [SortedEdge][channel].
    std::array<std::array<typename A::Number, 3>, 3> colourRate = {};
};

/// Everything that one column of the scan uses: the numbers that the assignment names.
template <class A>
struct ColumnState {
    using Number = typename A::Number;

    std::int64_t x = 0; ///< px
    ColumnHalf half = ColumnHalf::First;
    LongEdge longEdge = LongEdge::Above; ///< the side of the span that L₀₂ bounds in this column
    Number yBottom = {}; ///< y_B, px
    Number yTop = {}; ///< y_T, px
    std::array<Number, 3> colourBottom = {}; ///< R_B G_B B_B, levels
    std::array<Number, 3> colourTop = {}; ///< R_T G_T B_T, levels
    std::array<Number, 3> colourRate = {}; ///< Δ_R Δ_G Δ_B, levels per row
    std::int64_t firstRow = 0; ///< ⌈y_B⌉, or ⌊y_B⌋ + 1 where y_B itself is not covered
    std::int64_t endRow = 0; ///< one past the last covered row: ⌊y_T⌋ + 1 or ⌈y_T⌉
    std::int64_t firstDrawn = 0; ///< the same, clipped to the frame
    std::int64_t endDrawn = 0;
    std::array<Number, 3> firstColour = {}; ///< R G B at firstDrawn, levels
};

/// What became of a sample that a kernel visited.
enum class SampleFate { Written, Refused };

/// What coloured one pixel.
template <class A>
struct Fragment {
    std::array<typename A::Number, 3> colour = {}; ///< levels, before rounding
    std::array<std::int64_t, 3> level = {}; ///< rounded, before clamping to 0 … 255

    bool isClamped() const
    {
        for (const std::int64_t value : level) {
            if (value < 0 || value > 255)
                return true;
        }
        return false;
    }
};

/// The numbers of the column scan in one arithmetic, as its observers receive them.
template <class A>
struct ColumnScanNumbers {
    using SetUp = ColumnSetUp<A>;
    using Span = ColumnState<A>;
    using Sample = Fragment<A>;
};

} // namespace pixelplumb
