// SPDX-License-Identifier: GPL-3.0-or-later
// Which samples of a column, a row or a strip a triangle covers. Compiled once for each instruction
// set.
#include "core/fast/boundinglines.h"
#include "core/fast/pixelvectors-inl.h"

#if defined(PIXELPLUMB_SPANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_SPANS_INL
#undef PIXELPLUMB_SPANS_INL
#else
#define PIXELPLUMB_SPANS_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A rectangle of samples, counted from the window's first one.
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

    /// Computes columns origin … origin + Count − 1, of which those in `columns` have spans,
    /// clipped to `limit`. In each lane: first = ⌈max of the lower lines⌉, end = ⌈min of the upper
    /// ones⌉.
    HWY_INLINE void compute(const BoundingLines &lines, std::int32_t origin, Range columns,
                            Range limit)
    {
        constexpr hn::CappedTag<double, Count> reals{};
        constexpr hn::Rebind<std::int32_t, decltype(reals)> integers{};
        constexpr int lanes = lanesOf<hn::CappedTag<double, Count>>;
        const auto real = [&](double value) HWY_ATTR { return hn::Set(reals, value); };
        const auto limitFirst = real(limit.first);
        const auto limitEnd = real(limit.end);
        for (int k = 0; k < Count; k += lanes) {
            const auto column = countFrom(reals, double(origin + k));
            const auto at = [&](const BoundingLine &line) HWY_ATTR {
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

/// The spans of one vector's columns during the walk: each lane has the distance of the current row
/// above the span's first row, and the span's height.
template <class D>
class ColumnSpans {
    using Integers = hn::RebindToSigned<D>;
    using Integer = hn::Vec<Integers>;
    /// Maps 0 to the least integer: an unsigned a < b becomes a signed comparison.
    static constexpr std::int32_t signBit = std::numeric_limits<std::int32_t>::min();

public:
    /// Columns from `column` on, of which those in `box` have spans; the walk starts at `row`.
    HWY_INLINE ColumnSpans(const BoundingLines &lines, std::int32_t column, const SampleBox &box,
                           std::int32_t row)
    {
        constexpr Integers integers{};
#if HWY_TARGET == HWY_SCALAR
        const Bounds<hn::Rebind<double, Integers>> bounds(lines, column, box);
        const Integer first = bounds.first;
        const Integer end = bounds.end;
#else
        using Part = hn::Rebind<double, hn::Half<Integers>>;
        const Bounds<Part> low(lines, column, box);
        const Bounds<Part> high(lines, column + lanesOf<Part>, box);
        const Integer first = hn::Combine(integers, high.first, low.first);
        const Integer end = hn::Combine(integers, high.end, low.end);
#endif
        m_height = hn::Add(hn::Sub(end, first), hn::Set(integers, signBit));
        m_above = hn::Sub(hn::Set(integers, row + signBit), first);
    }

    HWY_INLINE hn::Mask<Integers> covered() const { return hn::Lt(m_above, m_height); }
    HWY_INLINE void climb(std::int32_t rows)
    {
        m_above = hn::Add(m_above, hn::Set(Integers(), rows));
    }

private:
    /// [first, end) in each lane, empty as [n, n).
    template <class Reals>
    struct Bounds {
        using Narrow = hn::Rebind<std::int32_t, Reals>;
        hn::Vec<Narrow> first;
        hn::Vec<Narrow> end;

        HWY_INLINE Bounds(const BoundingLines &lines, std::int32_t origin, const SampleBox &box)
        {
            constexpr Reals reals{};
            const auto real = [](double value) HWY_ATTR { return hn::Set(Reals(), value); };
            const auto column = countFrom(reals, double(origin));
            const auto at = [&](const BoundingLine &line) HWY_ATTR {
                return hn::Add(real(line.constant), hn::Mul(real(line.slope), column));
            };
            const auto lower = hn::Ceil(hn::Max(at(lines.lower[0]), at(lines.lower[1])));
            const auto upper = hn::Ceil(hn::Min(at(lines.upper[0]), at(lines.upper[1])));
            const auto isInside = hn::And(hn::Ge(column, real(box.firstColumn)),
                                          hn::Lt(column, real(box.endColumn)));
            const auto from = hn::Min(hn::Max(lower, real(box.firstRow)), real(box.endRow));
            const auto to = hn::Max(hn::Min(upper, real(box.endRow)), from);
            first = hn::DemoteTo(Narrow(), from);
            end = hn::DemoteTo(Narrow(), hn::IfThenElse(isInside, to, from));
        }
    };

    Integer m_above;
    Integer m_height;
};

/// The rows of neighbouring strips: partly covered in [first, firstFull) and [endFull, end); in
/// [firstFull, endFull) every column is covered and no mask is needed. `first` and `end` may lie a
/// little outside the triangle.
struct StripRows {
    static constexpr int capacity = 8;
    alignas(64) std::array<std::int32_t, capacity> first;
    alignas(64) std::array<std::int32_t, capacity> firstFull;
    alignas(64) std::array<std::int32_t, capacity> endFull;
    alignas(64) std::array<std::int32_t, capacity> end;

    /// Computes strips of `width` columns each, the first at `origin`, none beginning after `last`.
    /// Lines have their least and greatest values at a strip's ends, and rounding keeps that order.
    HWY_INLINE void compute(const BoundingLines &lines, std::int32_t origin, std::int32_t width,
                            std::int32_t last, const SampleBox &box)
    {
        constexpr hn::CappedTag<double, capacity> reals{};
        constexpr hn::Rebind<std::int32_t, decltype(reals)> integers{};
        constexpr int lanes = lanesOf<hn::CappedTag<double, capacity>>;
        const auto real = [&](double value) HWY_ATTR { return hn::Set(reals, value); };
        const auto store = [&](auto row, auto &to, int k) HWY_ATTR {
            const auto clipped
                = hn::Min(hn::Max(hn::Ceil(row), real(box.firstRow)), real(box.endRow));
            hn::Store(hn::DemoteTo(integers, clipped), integers, to.data() + k);
        };
        for (int k = 0; k < capacity; k += lanes) {
            const auto strip = hn::Mul(countFrom(reals, double(k)), real(width));
            const auto begin = hn::Min(hn::Add(strip, real(origin)), real(last));
            const auto back = hn::Add(begin, real(width - 1));
            const auto left = hn::Max(begin, real(box.firstColumn));
            const auto right = hn::Min(back, real(box.endColumn - 1));
            const auto isWhole = hn::And(hn::Eq(left, begin), hn::Eq(right, back));
            const auto at = [&](const BoundingLine &line, auto column) HWY_ATTR {
                return hn::Add(real(line.constant), hn::Mul(real(line.slope), column));
            };
            const auto lower0Left = at(lines.lower[0], left);
            const auto lower0Right = at(lines.lower[0], right);
            const auto lower1Left = at(lines.lower[1], left);
            const auto lower1Right = at(lines.lower[1], right);
            const auto upper0Left = at(lines.upper[0], left);
            const auto upper0Right = at(lines.upper[0], right);
            const auto upper1Left = at(lines.upper[1], left);
            const auto upper1Right = at(lines.upper[1], right);
            store(hn::Max(hn::Min(lower0Left, lower0Right), hn::Min(lower1Left, lower1Right)),
                  first, k);
            store(hn::Min(hn::Max(upper0Left, upper0Right), hn::Max(upper1Left, upper1Right)), end,
                  k);
            const auto from
                = hn::Max(hn::Max(lower0Left, lower0Right), hn::Max(lower1Left, lower1Right));
            const auto to
                = hn::Min(hn::Min(upper0Left, upper0Right), hn::Min(upper1Left, upper1Right));
            store(hn::IfThenElse(isWhole, from, real(box.endRow)), firstFull, k);
            store(to, endFull, k);
        }
    }
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
