// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/edgewalker.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/scanobserver.h"
#include "core/scan/walks/columnwalk.h"
#include "core/shade/shadedsample.h"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace pixelplumb {

/// The numbers of a shaded scan, as its observers receive them.
template <class N, class A>
struct ShadedNumbers {
    using SetUp = ShadedSetUpRead<N>;
    using Span = BoundedColumn<N, A>;
    using Sample = ShadedSample<N>;
};

/// An edge of the bilinear form in floating numbers: y and the vertices' values where it meets the
/// current column, each stepped by adding a rate.
template <class N>
struct ShadedEdge {
    using Number = typename N::Number;

    Number y, slope;
    PerChannel<Number> value, rate;

    ShadedEdge() = default;
    ShadedEdge(const ShadedCorner<N> &a, const ShadedCorner<N> &b, std::int64_t column,
               const ShadedChannels &carried)
    {
        const Number ax = NumberTraits<Number>::fromLattice(a.position.x);
        const Number width = NumberTraits<Number>::fromLattice(b.position.x) - ax;
        const Number run = Number(column) - ax;
        const auto start = [&](Number &first, Number &perColumn, Number atA, Number atB) {
            perColumn = width == Number(0) ? Number(0) : (atB - atA) / width;
            first = atA + run * perColumn;
        };
        start(y, slope, NumberTraits<Number>::fromLattice(a.position.y),
              NumberTraits<Number>::fromLattice(b.position.y));
        for (const std::size_t channel : carried)
            start(value[channel], rate[channel], a.channels[channel], b.channels[channel]);
    }

    void stepToNextColumn(const ShadedChannels &carried)
    {
        y = y + slope;
        for (const std::size_t channel : carried)
            value[channel] = value[channel] + rate[channel];
    }
};

/// The columns of one triangle, or of its segment where it has no area and the rule is closed, with
/// the numbers for shading their samples. Bounds are walked in A: exactly, or as in the float32
/// column scan.
template <class N, class A>
class ShadedScan {
public:
    using Column = BoundedColumn<N, A>;

    ShadedScan(const Triangle &triangle, const ShadedSetUp<N> &setUp, FillRule rule,
               FrameView frame)
        : m_triangle(triangle)
        , m_setUp(setUp)
        , m_rule(rule, frame.origin, frame.offScreenPoint)
        , m_intervals(columnIntervals(rule))
        , m_range(columnRangeOf(triangle, m_intervals.columns))
        , m_frame(frame)
    {
    }

    /// Calls fill(column) for each column that has samples in the frame. False where the triangle's
    /// box holds no sample of the frame.
    template <class Fill>
    bool run(const Fill &fill) const
    {
        const WalkedColumns columns = columnsInFrame(m_range, corners(), m_frame);
        if (columns.isEmpty())
            return false;
        if (m_setUp.zeroArea)
            walkSegment(
                corners(), columns, NullObserver{},
                [this](const SortedEnds &ends, std::int64_t column) {
                    return walkerOn(ends, column);
                },
                [&](ColumnHalf half, std::int64_t x, const Walker &lower, const Walker &upper) {
                    fill(columnBetween(half, m_intervals.rows, x, lower, upper));
                });
        else
            walkHalves(Filling<Fill>{*this, fill}, m_range, columns, NullObserver{});
        return true;
    }

    /// The column at any x, also outside the triangle, where its edges are extended. It has values
    /// at every row of the frame; it covers none.
    Column columnAt(std::int64_t x) const
    {
        const bool isSecond
            = at(1).x == at(0).x || (x * unitsPerPixel >= at(1).x && at(1).x < at(2).x);
        const Walker longEdge = walkerOn({0, 2}, x);
        const Walker shortEdge = isSecond ? walkerOn({1, 2}, x) : walkerOn({0, 1}, x);
        const bool longAbove = m_setUp.longEdge == LongEdge::Above;
        const Walker &bottom = longAbove ? shortEdge : longEdge;
        const Walker &top = longAbove ? longEdge : shortEdge;
        Column column;
        column.x = x;
        column.origin = ColumnOrigin::Direct;
        column.half = isSecond ? ColumnHalf::Second : ColumnHalf::First;
        column.longEdge = m_setUp.longEdge;
        column.lower = bottom.bound.y;
        column.upper = top.bound.y;
        setRates(bottom, top, column);
        return column;
    }

private:
    struct Walker {
        EdgeWalker<A, NoEdgeColours<A>> bound;
        /// For the bilinear form. Exact channels need no edge: the plane gives their values.
        std::conditional_t<N::isExact, std::monostate, ShadedEdge<N>> channels;
        const ShadedChannels *carried = nullptr; ///< none in other forms

        void stepToNextColumn()
        {
            bound.stepToNextColumn();
            if constexpr (!N::isExact) {
                if (carried)
                    channels.stepToNextColumn(*carried);
            }
        }
    };

    /// What the walk asks for (columnwalk.h).
    template <class Fill>
    struct Filling {
        static constexpr bool skipsEmptyHalf = true;
        const ShadedScan &scan;
        const Fill &fill;

        Walker walkerOn(const SortedEnds &ends, std::int64_t column) const
        {
            return scan.walkerOn(ends, column);
        }
        Interval rowsOf(const SortedEnds &shortEdge) const
        {
            return rowsBeside(scan.m_rule, scan.m_setUp.longEdge, scan.corners(), shortEdge);
        }
        void scanColumn(ColumnHalf half, Interval rows, std::int64_t x, const Walker &shortEdge,
                        const Walker &longEdge) const
        {
            fill(scan.columnBetween(half, rows, x, shortEdge, longEdge));
        }
    };

    std::size_t indexAt(std::size_t corner) const { return std::size_t(m_setUp.order[corner]); }
    const LatticePoint &at(std::size_t corner) const
    {
        return m_setUp.vertices[indexAt(corner)].position;
    }

    SortedCorners corners() const { return {at(0), at(1), at(2)}; }

    Walker walkerOn(const SortedEnds &ends, std::int64_t column) const
    {
        const std::size_t a = indexAt(ends[0]);
        const std::size_t b = indexAt(ends[1]);
        Walker walker{{m_triangle.vertices[a], m_triangle.vertices[b], column}, {}};
        if constexpr (!N::isExact) {
            if (m_setUp.form == InterpolationForm::Bilinear) {
                walker.carried = &m_setUp.carried;
                walker.channels
                    = {m_setUp.vertices[a], m_setUp.vertices[b], column, m_setUp.carried};
            }
        }
        return walker;
    }

    Column columnBetween(ColumnHalf half, Interval rows, std::int64_t x, const Walker &shortEdge,
                         const Walker &longEdge) const
    {
        Column column;
        column.x = x;
        column.origin = ColumnOrigin::Walked;
        column.half = half;
        column.longEdge = m_setUp.longEdge;
        if constexpr (A::boundsMayCross)
            column.longEdge = sideOfLongEdge(column.longEdge, m_intervals.rows, shortEdge.bound.y,
                                             longEdge.bound.y);
        const bool longAbove = column.longEdge == LongEdge::Above;
        const Walker &bottom = longAbove ? shortEdge : longEdge;
        const Walker &top = longAbove ? longEdge : shortEdge;
        column.lower = bottom.bound.y;
        column.upper = top.bound.y;
        coverRows<A>(column, rows, column.lower, column.upper, m_frame);
        setRates(bottom, top, column);
        return column;
    }

    /// For the bilinear form.
    void setRates(const Walker &bottom, const Walker &top, Column &column) const
    {
        if (m_setUp.form != InterpolationForm::Bilinear)
            return;
        if constexpr (N::isExact) {
            // The rate of every column is the plane's b, and the values on the bounds are the
            // plane's: the same numbers as (v_T − v_B)/(y_T − y_B), without a division.
            for (const std::size_t channel : m_setUp.carried) {
                const auto &plane = m_setUp.plane[channel];
                column.rate[channel] = plane[1];
                column.atRow0[channel] = plane[0] * column.x + plane[2];
            }
        } else {
            using Number = typename N::Number;
            column.yBottom = bottom.channels.y;
            column.yTop = top.channels.y;
            const Number height = column.yTop - column.yBottom;
            for (const std::size_t channel : m_setUp.carried) {
                column.bottom[channel] = bottom.channels.value[channel];
                column.top[channel] = top.channels.value[channel];
                column.rate[channel] = height == Number(0)
                    ? Number(0)
                    : (column.top[channel] - column.bottom[channel]) / height;
            }
        }
    }

    const Triangle &m_triangle;
    const ShadedSetUp<N> &m_setUp;
    BoundaryRule m_rule;
    ScanIntervals m_intervals;
    ColumnRange m_range;
    FrameView m_frame;
};

} // namespace pixelplumb
