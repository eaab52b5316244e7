// SPDX-License-Identifier: GPL-3.0-or-later
// The column scan in strips. Compiled once for each instruction set.
#include "core/fast/spans-inl.h"

#if defined(PIXELPLUMB_STRIPSCAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_STRIPSCAN_INL
#undef PIXELPLUMB_STRIPSCAN_INL
#else
#define PIXELPLUMB_STRIPSCAN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The colours and spans of the vectors side by side in a strip, unrolled at compile time so that
/// each stays in registers.
template <class Colour, class D, int Vectors>
struct StripRow {
    static constexpr int lanes = lanesOf<D>;

    typename Colour::State state;
    ColumnSpans<D> spans;
    StripRow<Colour, D, Vectors - 1> rest;

    HWY_INLINE StripRow(const Colour &colour, const BoundingLines &lines, std::int32_t column,
                        std::int32_t row, const SampleBox &box, std::int32_t originColumn,
                        std::int32_t originRow)
        : state(colour.begin(column - originColumn, row - originRow))
        , spans(lines, column, box, row)
        , rest(colour, lines, column + lanes, row, box, originColumn, originRow)
    {
    }
    /// Stores a row in which every column is covered.
    HWY_INLINE void store(const Colour &colour, QRgb *to)
    {
        hn::StoreU(colour.pixels(state), D(), to);
        colour.advance(state);
        rest.store(colour, to + lanes);
    }
    /// To be called with the number of store() calls made.
    HWY_INLINE void climb(std::int32_t rows)
    {
        spans.climb(rows);
        rest.climb(rows);
    }
    /// Stores the columns whose spans contain the row.
    HWY_INLINE void storeCovered(const Colour &colour, QRgb *to)
    {
        constexpr D d{};
        storeWhere(d, hn::RebindMask(d, spans.covered()), colour.pixels(state), to);
        colour.advance(state);
        spans.climb(1);
        rest.storeCovered(colour, to + lanes);
    }
};

template <class Colour, class D>
struct StripRow<Colour, D, 0> {
    HWY_INLINE StripRow(const Colour &, const BoundingLines &, std::int32_t, std::int32_t,
                        const SampleBox &, std::int32_t, std::int32_t)
    {
    }
    HWY_INLINE void store(const Colour &, QRgb *) { }
    HWY_INLINE void climb(std::int32_t) { }
    HWY_INLINE void storeCovered(const Colour &, QRgb *) { }
};

/// Draws a strip of neighbouring columns, each with its own y_B, y_T and colour in a lane, row by
/// row: a row is a few adjacent stores, where the column walk touches one cache line per pixel.
template <class Colour, class D, int Vectors>
class StripScan {
    static constexpr int lanes = lanesOf<D>;
    static constexpr int columns = lanes * Vectors;
    /// A separate loop costs a mispredicted branch or two: as much as the masks of this many rows.
    static constexpr std::int32_t fewestFullRows = 12;
    /// How many rows ahead a tall strip prefetches its lines: stores retire in order, so each would
    /// wait for its own line.
    static constexpr std::int32_t prefetchedRows = 24;

public:
    /// `box`: what is drawn. (originColumn, originRow): the origin of the colour plane.
    StripScan(const FrameView &window, const BoundingLines &lines, const SampleBox &box,
              std::int32_t originColumn, std::int32_t originRow)
        : m_window(window)
        , m_lines(lines)
        , m_box(box)
        , m_originColumn(originColumn)
        , m_originRow(originRow)
    {
    }

    /// Draws the columns of the box from left to right, in strips that begin on cache lines unless
    /// one strip holds them all. A strip that would extend beyond the window's border is moved
    /// inside: the columns that two strips share are drawn twice in the same colours.
    HWY_INLINE void run(const Colour &colour) const
    {
        const std::int32_t last = m_window.width - std::int32_t(columns);
        std::int32_t column = HWY_MIN(m_box.firstColumn, last);
        if (m_box.endColumn - column <= columns) {
            scanTallStrip(colour, column);
            return;
        }
        const auto address = reinterpret_cast<std::uintptr_t>(m_window.base + column);
        column -= std::int32_t(address / sizeof(QRgb) % HWY_MIN(columns, 16));
        column = HWY_MAX(column, 0);
        while (column < m_box.endColumn) {
            StripRows rows;
            rows.compute(m_lines, column, columns, last, m_box);
            for (std::size_t k = 0; k < StripRows::capacity && column < m_box.endColumn; ++k) {
                scanStrip(colour, HWY_MIN(column, last), rows, k);
                column += columns;
            }
        }
    }

private:
    HWY_INLINE auto rowAt(const Colour &colour, std::int32_t column, std::int32_t row) const
    {
        return StripRow<Colour, D, Vectors>(colour, m_lines, column, row, m_box, m_originColumn,
                                            m_originRow);
    }

    HWY_INLINE void scanTallStrip(const Colour &colour, std::int32_t column) const
    {
        auto row = rowAt(colour, column, m_box.firstRow);
        QRgb *to = m_window.base + m_box.firstRow * m_window.stride + column;
        const auto ahead = std::uintptr_t(prefetchedRows * m_window.stride) * sizeof(QRgb);
        for (std::int32_t y = m_box.firstRow; y < m_box.endRow; ++y) {
            prefetchForStore(reinterpret_cast<std::uintptr_t>(to) + ahead);
            row.storeCovered(colour, to);
            to += m_window.stride;
        }
    }

    HWY_INLINE void scanStrip(const Colour &colour, std::int32_t column, const StripRows &rows,
                              std::size_t k) const
    {
        const std::int32_t first = rows.first[k];
        const std::int32_t end = rows.end[k];
        if (first >= end)
            return;
        auto row = rowAt(colour, column, first);
        QRgb *to = m_window.base + first * m_window.stride + column;
        const auto storeCovered = [&](std::int32_t count) HWY_ATTR {
            for (std::int32_t n = 0; n < count; ++n) {
                row.storeCovered(colour, to);
                to += m_window.stride;
            }
        };
        const std::int32_t full = rows.endFull[k] - rows.firstFull[k];
        if (full < fewestFullRows)
            return storeCovered(end - first);
        storeCovered(rows.firstFull[k] - first);
        for (std::int32_t n = 0; n < full; ++n) {
            row.store(colour, to);
            to += m_window.stride;
        }
        row.climb(full);
        storeCovered(end - rows.endFull[k]);
    }

    const FrameView &m_window;
    const BoundingLines &m_lines;
    SampleBox m_box;
    std::int32_t m_originColumn;
    std::int32_t m_originRow;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
