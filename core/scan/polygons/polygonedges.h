// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/polygons/polygonrows.h"

#include <algorithm>
#include <compare>
#include <span>

namespace pixelplumb {

/// The edge table: all edges but the horizontal ones, from lower to upper end, sorted by the first
/// row that they cross. A sample counts as displaced to the right and, less, down on the screen, so
/// an edge crosses the rows of rowsCrossed().
template <class A>
class EdgeTable {
public:
    /// `edges` must outlive the table.
    EdgeTable(std::span<const ContourEdge> edges, FrameOrigin origin)
        : m_edges(edges)
        , m_origin(origin)
    {
        const auto isCrossed = [](const ContourEdge &edge) { return edge.from.y != edge.to.y; };
        const Interval rows = rowsCrossed(origin);
        m_entries.reserve(std::size_t(std::ranges::count_if(edges, isCrossed)));
        for (std::size_t index = 0; index < edges.size(); ++index) {
            const ContourEdge &edge = edges[index];
            if (isCrossed(edge))
                m_entries.push_back(
                    {firstSampleFrom(std::min(edge.from.y, edge.to.y), rows), index});
        }
        std::ranges::sort(m_entries);
    }

    std::size_t size() const { return m_entries.size(); }
    /// No edge is crossed before this row; meaningful when there are edges.
    std::int64_t firstRow() const { return m_entries.front().firstRow; }

    /// Moves the edges that first cross this row into the active list; rows must ascend. An edge
    /// that began on an earlier row, below the frame, starts here with a longer pre-step.
    void activate(std::int64_t row, std::vector<Crossing<A>> &active)
    {
        for (; m_next < m_entries.size() && m_entries[m_next].firstRow <= row; ++m_next) {
            const Upward edge(m_edges[m_entries[m_next].index]);
            const std::int64_t endRow = endSampleAt(edge.high.y, rowsCrossed(m_origin));
            if (endRow > row)
                active.push_back(started(m_entries[m_next].index, endRow, row));
        }
    }

private:
    /// Small, since a text may have millions of edges.
    struct Entry {
        std::int64_t firstRow = 0;
        std::size_t index = 0;

        friend auto operator<=>(const Entry &, const Entry &) = default;
    };
    struct Upward {
        explicit Upward(const ContourEdge &edge)
            : low(edge.from.y < edge.to.y ? edge.from : edge.to)
            , high(edge.from.y < edge.to.y ? edge.to : edge.from)
        {
        }

        LatticePoint low, high;
    };

    /// x and y exchanged: the arithmetics walk along columns.
    static Vertex mirrored(const LatticePoint &point) { return {{point.y, point.x}, {}}; }

    Crossing<A> started(std::size_t index, std::int64_t endRow, std::int64_t row) const
    {
        const Upward edge(m_edges[index]);
        const Vertex low = mirrored(edge.low);
        const Vertex high = mirrored(edge.high);
        Crossing<A> crossing;
        crossing.edge = index;
        crossing.turn = windingRightOf(m_edges[index], m_origin);
        crossing.endRow = endRow;
        crossing.slope = A::edgeSlope(low, high);
        crossing.base = onLattice(low.position.y);
        const auto run = A::runTo(row, low);
        if constexpr (A::arithmetic == Arithmetic::Exact)
            crossing.rise = A::Number::fromFraction(run, unitsPerPixel);
        else
            crossing.rise = run;
        crossing.x = A::edgeOrdinate(low, high, run, crossing.slope);
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

    std::span<const ContourEdge> m_edges;
    FrameOrigin m_origin;
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
