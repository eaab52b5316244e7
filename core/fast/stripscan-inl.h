// SPDX-License-Identifier: GPL-3.0-or-later
// The column scan in strips. Compiled once for each instruction set.
#include "core/fast/edgelines.h"
#include "core/fast/pixelvectors-inl.h"

#if defined(PIXELPLUMB_STRIPSCAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_STRIPSCAN_INL
#undef PIXELPLUMB_STRIPSCAN_INL
#else
#define PIXELPLUMB_STRIPSCAN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A rectangle of samples counted from the window's first one.
struct SampleBox {
    std::int32_t firstColumn;
    std::int32_t endColumn;
    std::int32_t firstRow;
    std::int32_t endRow;
};

/// The spans of `Count` neighbouring columns (or rows): [first[k], end[k]), an empty one as
/// [limit.end, limit.first).
template <int Count>
struct Spans {
    alignas(64) std::array<std::int32_t, Count> first;
    alignas(64) std::array<std::int32_t, Count> end;

    struct Range {
        std::int32_t first;
        std::int32_t end;
    };

    /// The rows of all columns together: partly covered in [first, firstFull) and [endFull, end),
    /// covered in every column, so that no mask is needed, in [firstFull, endFull).
    struct Rows {
        std::int32_t first;
        std::int32_t firstFull;
        std::int32_t endFull;
        std::int32_t end;
    };
    HWY_INLINE Rows rows() const
    {
        constexpr hn::CappedTag<std::int32_t, Count> d{};
        constexpr int lanes = lanesOf<hn::CappedTag<std::int32_t, Count>>;
        auto leastFirst = hn::Load(d, first.data());
        auto greatestFirst = leastFirst;
        auto leastEnd = hn::Load(d, end.data());
        auto greatestEnd = leastEnd;
        for (int k = lanes; k < Count; k += lanes) {
            const auto nextFirst = hn::Load(d, first.data() + k);
            const auto nextEnd = hn::Load(d, end.data() + k);
            leastFirst = hn::Min(leastFirst, nextFirst);
            greatestFirst = hn::Max(greatestFirst, nextFirst);
            leastEnd = hn::Min(leastEnd, nextEnd);
            greatestEnd = hn::Max(greatestEnd, nextEnd);
        }
        Rows rows = {hn::GetLane(hn::MinOfLanes(d, leastFirst)),
                     hn::GetLane(hn::MaxOfLanes(d, greatestFirst)),
                     hn::GetLane(hn::MinOfLanes(d, leastEnd)),
                     hn::GetLane(hn::MaxOfLanes(d, greatestEnd))};
        if (rows.firstFull >= rows.endFull)
            rows.firstFull = rows.endFull = HWY_MAX(rows.first, rows.end);
        return rows;
    }

    /// Columns origin … origin + Count − 1, of which those in `columns` have spans, clipped to
    /// `limit`. In each lane: first = ⌈max of the lower lines⌉, end = ⌈min of the upper ones⌉.
    HWY_INLINE void compute(const EdgeLines &lines, std::int32_t origin, Range columns, Range limit)
    {
        constexpr hn::CappedTag<double, Count> reals{};
        constexpr hn::Rebind<std::int32_t, decltype(reals)> integers{};
        constexpr int lanes = lanesOf<hn::CappedTag<double, Count>>;
        const auto real = [&](double value) HWY_ATTR { return hn::Set(reals, value); };
        const auto limitFirst = real(limit.first);
        const auto limitEnd = real(limit.end);
        for (int k = 0; k < Count; k += lanes) {
            const auto column = countFrom(reals, double(origin + k));
            const auto at = [&](const EdgeLine &line) HWY_ATTR {
                return hn::Add(real(line.constant), hn::Mul(real(line.slope), column));
            };
            const auto lower = hn::Ceil(hn::Max(at(lines.lower[0]), at(lines.lower[1])));
            const auto upper = hn::Ceil(hn::Min(at(lines.upper[0]), at(lines.upper[1])));
            const auto from = hn::Min(hn::Max(lower, limitFirst), limitEnd);
            const auto to = hn::Min(hn::Max(upper, limitFirst), limitEnd);
            const auto isInside
                = hn::And(hn::Ge(column, real(columns.first)), hn::Lt(column, real(columns.end)));
            const auto covers = hn::And(isInside, hn::Lt(from, to));
            hn::Store(hn::DemoteTo(integers, hn::IfThenElse(covers, from, limitEnd)), integers,
                      first.data() + k);
            hn::Store(hn::DemoteTo(integers, hn::IfThenElse(covers, to, limitFirst)), integers,
                      end.data() + k);
        }
    }
};

/// The colours of the vectors that stand side by side in a strip, unrolled at compile time so that
/// each stays in registers.
template <class Colour, class D, int Vectors>
struct StripRow {
    static constexpr int lanes = lanesOf<D>;

    typename Colour::State state;
    StripRow<Colour, D, Vectors - 1> rest;

    static HWY_INLINE StripRow begin(const Colour &colour, std::int64_t column, std::int64_t row)
    {
        return {colour.begin(column, row),
                StripRow<Colour, D, Vectors - 1>::begin(colour, column + lanes, row)};
    }
    /// Stores a row in which every column is covered.
    HWY_INLINE void store(const Colour &colour, QRgb *to)
    {
        hn::StoreU(colour.pixels(state), D(), to);
        colour.advance(state);
        rest.store(colour, to + lanes);
    }
    /// Stores those columns whose spans hold the row.
    HWY_INLINE void storeCovered(const Colour &colour, const std::int32_t *first,
                                 const std::int32_t *end, std::int32_t row, QRgb *to)
    {
        constexpr D d{};
        constexpr hn::RebindToSigned<D> di{};
        const auto here = hn::Set(di, row);
        const auto covered
            = hn::AndNot(hn::Gt(hn::Load(di, first), here), hn::Lt(here, hn::Load(di, end)));
        storeWhere(d, hn::RebindMask(d, covered), colour.pixels(state), to);
        colour.advance(state);
        rest.storeCovered(colour, first + lanes, end + lanes, row, to + lanes);
    }
};

template <class Colour, class D>
struct StripRow<Colour, D, 0> {
    static HWY_INLINE StripRow begin(const Colour &, std::int64_t, std::int64_t) { return {}; }
    HWY_INLINE void store(const Colour &, QRgb *) { }
    HWY_INLINE void storeCovered(const Colour &, const std::int32_t *, const std::int32_t *,
                                 std::int32_t, QRgb *)
    {
    }
};

/// A strip of neighbouring columns, each with its own y_B, y_T and colour in a lane, walked row by
/// row: a row is a few stores side by side, where the column walk touches a cache line a pixel.
template <class Colour, class D, int Vectors>
class StripScan {
    static constexpr int lanes = lanesOf<D>;
    static constexpr int columns = lanes * Vectors;

public:
    /// `box`: what is drawn. (originColumn, originRow): where the colour's plane starts.
    StripScan(const FrameView &window, const EdgeLines &lines, const SampleBox &box,
              std::int32_t originColumn, std::int32_t originRow)
        : m_window(window)
        , m_lines(lines)
        , m_box(box)
        , m_originColumn(originColumn)
        , m_originRow(originRow)
    {
    }

    /// The columns of the box from left to right, in strips that begin on cache lines unless one
    /// strip holds them all.
    HWY_INLINE void run(const Colour &colour) const
    {
        std::int32_t column = m_box.firstColumn;
        if (m_box.endColumn - m_box.firstColumn > columns) {
            const auto address = reinterpret_cast<std::uintptr_t>(m_window.base + column);
            column -= std::int32_t(address / sizeof(QRgb) % HWY_MIN(columns, 16));
        }
        for (; column < m_box.endColumn; column += columns) {
            // A strip that would reach over the window's border is moved inside: the columns that
            // two strips share are drawn twice in the same colours.
            scanStrip(colour, HWY_MAX(0, HWY_MIN(column, m_window.width - std::int32_t(columns))));
        }
    }

private:
    HWY_INLINE void scanStrip(const Colour &colour, std::int32_t column) const
    {
        Spans<columns> spans;
        spans.compute(m_lines, column, {m_box.firstColumn, m_box.endColumn},
                      {m_box.firstRow, m_box.endRow});
        const auto rows = spans.rows();
        if (rows.first >= rows.end)
            return;
        auto row = StripRow<Colour, D, Vectors>::begin(colour, column - m_originColumn,
                                                       rows.first - m_originRow);
        QRgb *to = m_window.base + rows.first * m_window.stride + column;
        const auto storeCovered = [&](std::int32_t from, std::int32_t end) HWY_ATTR {
            for (std::int32_t y = from; y < end; ++y) {
                row.storeCovered(colour, spans.first.data(), spans.end.data(), y, to);
                to += m_window.stride;
            }
        };
        storeCovered(rows.first, rows.firstFull);
        for (std::int32_t y = rows.firstFull; y < rows.endFull; ++y) {
            row.store(colour, to);
            to += m_window.stride;
        }
        storeCovered(rows.endFull, rows.end);
    }

    const FrameView &m_window;
    const EdgeLines &m_lines;
    SampleBox m_box;
    std::int32_t m_originColumn;
    std::int32_t m_originRow;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
