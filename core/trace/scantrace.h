// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/scanobserver.h"
#include "core/trace/pixelchanges.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace pixelplumb {

/// What a step of a trace did.
enum class StepKind {
    SetUp, ///< a triangle was begun (or refused)
    Column, ///< a column was entered: its numbers are known, none of its pixels is written
    Pixel, ///< a pixel was written
};

/// Where a step stands in the trace. Indices count through all triangles.
struct TraceStep {
    StepKind kind = StepKind::SetUp;
    std::size_t triangle = 0;
    std::size_t column = 0; ///< meaningful for Column and Pixel
    std::size_t pixel = 0; ///< meaningful for Pixel

    friend bool operator==(const TraceStep &, const TraceStep &) = default;
};

/// What was computed once for a triangle, in any arithmetic.
struct SetUpRecord {
    std::size_t triangle = 0;
    std::array<int, 3> order = {};
    LongEdge longEdge = LongEdge::Above;
    bool zeroArea = false;
    std::int64_t firstColumn = 0;
    std::int64_t middleColumn = 0;
    std::int64_t endColumn = 0;
    std::array<Quantity, 3> slope; ///< by SortedEdge
    std::array<std::array<Quantity, 3>, 3> colourRate; ///< [SortedEdge][channel]
    std::optional<TriangleRejection> rejection;
};

/// The numbers of one column, in any arithmetic.
struct ColumnRecord {
    std::size_t triangle = 0;
    std::int64_t x = 0;
    ColumnHalf half = ColumnHalf::First;
    Quantity yBottom, yTop;
    std::array<Quantity, 3> colourBottom, colourTop, colourRate, firstColour;
    std::int64_t firstRow = 0, endRow = 0; ///< unclipped
    std::int64_t firstDrawnRow = 0, endDrawnRow = 0; ///< clipped to the frame

    std::int64_t drawnPixels() const
    {
        return std::max<std::int64_t>(0, endDrawnRow - firstDrawnRow);
    }
};

/// The numbers of one pixel, in any arithmetic.
struct FragmentRecord {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::array<Quantity, 3> colour; ///< levels, before rounding
    std::array<std::int64_t, 3> level = {}; ///< rounded, before clamping
    bool clamped = false;
};

/// The record of a whole run: what the kernel announced, in the numbers that it used. A position p
/// in 0 … stepCount() means that the first p steps are done; step p − 1 is the step in hand.
class ScanTrace {
public:
    virtual ~ScanTrace() = default;

    const ScanSettings &settings() const { return m_settings; }
    /// True when the recorder's limit ended the recording early.
    bool isCut() const { return m_cut; }

    std::size_t triangleCount() const { return m_triangles.size(); }
    std::size_t columnCount() const { return m_columns.size(); }
    std::size_t pixelCount() const { return m_pixels.size(); }
    std::size_t stepCount() const { return triangleCount() + columnCount() + pixelCount(); }

    /// The step with an index in 0 … stepCount() − 1.
    TraceStep stepAt(std::size_t index) const;
    std::size_t indexOfSetUp(std::size_t triangle) const { return m_triangles[triangle].step; }
    std::size_t indexOfColumn(std::size_t column) const { return m_columns[column].step; }
    std::size_t indexOfPixel(std::size_t pixel) const;

    /// How many pixel changes are done at a position.
    std::size_t pixelsDoneAt(std::size_t position) const;

    const PixelChanges &changes() const { return m_pixels; }
    /// The pixels whose levels left 0 … 255, ascending.
    const std::vector<std::size_t> &clampedPixels() const { return m_clampedPixels; }
    std::size_t firstColumnOf(std::size_t triangle) const
    {
        return m_triangles[triangle].firstColumn;
    }
    std::size_t endColumnOf(std::size_t triangle) const;
    std::size_t firstPixelOf(std::size_t column) const { return m_columns[column].firstPixel; }
    std::size_t endPixelOf(std::size_t column) const;
    /// The triangle to which a column belongs.
    std::size_t triangleOf(std::size_t column) const;
    std::int64_t xOf(std::size_t column) const { return m_columns[column].x; }
    ColumnHalf halfOf(std::size_t column) const { return m_columns[column].half; }
    /// The column to which a pixel belongs.
    std::size_t columnOf(std::size_t pixel) const;

    virtual SetUpRecord setUp(std::size_t triangle) const = 0;
    virtual ColumnRecord column(std::size_t column) const = 0;
    /// The column's fragments, bottom to top: the kernel's own pixel loop run again from the
    /// column's recorded state.
    virtual std::vector<FragmentRecord> fragments(std::size_t column) const = 0;

protected:
    struct TriangleEntry {
        std::size_t step = 0;
        std::size_t firstColumn = 0;
    };
    struct ColumnEntry {
        std::size_t step = 0;
        std::size_t firstPixel = 0;
        std::size_t triangle = 0;
        std::int64_t x = 0;
        ColumnHalf half = ColumnHalf::First;
    };

    explicit ScanTrace(const ScanSettings &settings)
        : m_settings(settings)
    {
    }

    ScanSettings m_settings;
    bool m_cut = false;
    std::vector<TriangleEntry> m_triangles;
    std::vector<ColumnEntry> m_columns;
    PixelChanges m_pixels;
    std::vector<std::size_t> m_clampedPixels;
};

} // namespace pixelplumb
