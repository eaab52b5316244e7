// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/polygons/polygonrows.h"

#include <algorithm>
#include <span>

namespace pixelplumb {

/// The edge table: all edges but the horizontal ones, from lower to upper end, sorted by the first
/// row that they cross. A sample counts as displaced to the right and, less, down on the screen, so
/// an edge crosses the rows of rowsCrossed().
template <class A>
class EdgeTable {
public:
    EdgeTable(std::span<const ContourEdge> edges, FrameOrigin origin)
    {
        const Interval rows = rowsCrossed(origin);
        for (std::size_t index = 0; index < edges.size(); ++index) {
            const LatticePoint &from = edges[index].from;
            const LatticePoint &to = edges[index].to;
            if (from.y == to.y)
                continue;
            const bool upward = from.y < to.y;
            const LatticePoint &low = upward ? from : to;
            const LatticePoint &high = upward ? to : from;
            m_entries.push_back({mirrored(low), mirrored(high), index,
                                 windingRightOf(edges[index], origin), firstSampleFrom(low.y, rows),
                                 endSampleAt(high.y, rows)});
        }
        std::ranges::stable_sort(m_entries, {}, &Entry::firstRow);
    }

    std::size_t size() const { return m_entries.size(); }
    /// No edge is crossed before this row; meaningful when there are edges.
    std::int64_t firstRow() const { return m_entries.front().firstRow; }

    /// Moves the edges that first cross this row into the active list; rows must ascend. An edge
    /// that began on an earlier row, below the frame, starts here with a longer pre-step.
    void activate(std::int64_t row, std::vector<Crossing<A>> &active)
    {
        for (; m_next < m_entries.size() && m_entries[m_next].firstRow <= row; ++m_next) {
            const Entry &entry = m_entries[m_next];
            if (entry.endRow > row)
                active.push_back(started(entry, row));
        }
    }

private:
    struct Entry {
        Vertex low, high; ///< x and y exchanged: the arithmetics walk along columns
        std::size_t index = 0;
        int turn = 0;
        std::int64_t firstRow = 0, endRow = 0;
    };

    static Vertex mirrored(const LatticePoint &point) { return {{point.y, point.x}, {}}; }

    static Crossing<A> started(const Entry &entry, std::int64_t row)
    {
        Crossing<A> crossing;
        crossing.edge = entry.index;
        crossing.turn = entry.turn;
        crossing.endRow = entry.endRow;
        crossing.slope = A::edgeSlope(entry.low, entry.high);
        crossing.base = onLattice(entry.low.position.y);
        const auto run = A::runTo(row, entry.low);
        if constexpr (A::arithmetic == Arithmetic::Exact)
            crossing.rise = A::Number::fromFraction(run, unitsPerPixel);
        else
            crossing.rise = run;
        crossing.x = A::edgeOrdinate(entry.low, entry.high, run, crossing.slope);
        crossing.firstRight = A::ceil(crossing.x);
        return crossing;
    }

    static typename A::Number onLattice(Lattice units)
    {
        if constexpr (A::arithmetic == Arithmetic::Exact)
            return A::Number::fromFraction(units, unitsPerPixel);
        else
            return A::Traits::fromLattice(units);
    }

    std::vector<Entry> m_entries; ///< ascending by first row
    std::size_t m_next = 0; ///< the first entry not yet activated
};

/// The edges that the current row crosses, ascending in x: the state passed from row to row.
template <class A>
class ActiveEdges {
public:
    const std::vector<Crossing<A>> &crossings() const { return m_crossings; }

    /// Adds the edges that begin on the row and restores the order. Edges change places only where
    /// they cross.
    void enterRow(std::int64_t row, EdgeTable<A> &table)
    {
        table.activate(row, m_crossings);
        if (!std::ranges::is_sorted(m_crossings, isLeft))
            std::ranges::stable_sort(m_crossings, isLeft);
    }

    /// Drops the edges that end on the row; the others add their slope.
    void leaveRow(std::int64_t row)
    {
        std::erase_if(m_crossings,
                      [row](const Crossing<A> &crossing) { return crossing.endRow <= row + 1; });
        for (Crossing<A> &crossing : m_crossings) {
            crossing.base = crossing.x;
            crossing.rise = m_oneRow;
            A::advance(crossing.x, crossing.slope);
            crossing.firstRight = A::ceil(crossing.x);
        }
    }

private:
    static typename A::Number oneRow()
    {
        if constexpr (A::arithmetic == Arithmetic::Exact)
            return A::Number::fromWhole(1);
        else
            return A::Traits::fromInteger(1);
    }

    /// A strict weak order whatever the numbers are: NaN comes first.
    static bool isLeft(const Crossing<A> &a, const Crossing<A> &b)
    {
        if constexpr (A::arithmetic == Arithmetic::Exact) {
            if (a.x.whole != b.x.whole)
                return a.x.whole < b.x.whole;
            using Wide = WideBeside<typename A::Number>;
            return Wide(a.x.remainder) * b.x.denominator < Wide(b.x.remainder) * a.x.denominator;
        } else {
            const bool bIsNumber = b.x == b.x;
            return a.x < b.x || (bIsNumber && a.x != a.x);
        }
    }

    typename A::Number m_oneRow = oneRow();
    std::vector<Crossing<A>> m_crossings;
};

} // namespace pixelplumb
