// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/columnrecord.h"
#include "core/methods/explanation.h"
#include "core/oracle/oracle.h"
#include "core/trace/tracedscene.h"

#include <array>

namespace pixelplumb {

// The assignment's names, by channel, by SortedEdge and by vertex.
inline constexpr std::array channelSubjects
    = {FormulaSubject::Red, FormulaSubject::Green, FormulaSubject::Blue};
inline constexpr std::array<QStringView, 3> edgeNames = {u"L₀₁", u"L₁₂", u"L₀₂"};
inline constexpr std::array<QStringView, 3> edgeIndices = {u"₀₁", u"₁₂", u"₀₂"};
inline constexpr std::array<std::array<std::size_t, 2>, 3> edgeEnds = {{{0, 1}, {1, 2}, {0, 2}}};
inline constexpr std::array<QChar, 3> subscripts = {u'₀', u'₁', u'₂'};

/// One triangle of a traced scene with its vertices sorted as the scan sorts them.
class SortedTriangle {
public:
    SortedTriangle(const TracedScene &traced, std::size_t triangle)
        : m_setUp(traced.trace->setUp(triangle))
    {
        for (std::size_t i = 0; i < 3; ++i)
            m_vertices[i]
                = traced.primitives.triangles[triangle].vertices[std::size_t(m_setUp.order[i])];
    }

    const SetUpRecord &setUp() const { return m_setUp; }
    const Vertex &operator[](std::size_t index) const { return m_vertices[index]; }

    Quantity slope(SortedEdge edge) const
    {
        return cell(std::size_t(ColumnSetUpCell::Slope) + std::size_t(edge));
    }
    Quantity colourRate(SortedEdge edge, std::size_t channel) const
    {
        return cell(std::size_t(ColumnSetUpCell::ColourRate) + 3 * std::size_t(edge) + channel);
    }

    SortedEdge shortEdge(ColumnHalf half) const
    {
        if (m_setUp.zeroArea)
            return SortedEdge::L02;
        return half == ColumnHalf::First ? SortedEdge::L01 : SortedEdge::L12;
    }
    SortedEdge lowerEdge(ColumnHalf half) const
    {
        return m_setUp.longEdge == LongEdge::Above ? shortEdge(half) : SortedEdge::L02;
    }
    SortedEdge upperEdge(ColumnHalf half) const
    {
        return m_setUp.longEdge == LongEdge::Above ? SortedEdge::L02 : shortEdge(half);
    }
    const Vertex &start(SortedEdge edge) const
    {
        return m_vertices[edgeEnds[std::size_t(edge)][0]];
    }
    const Vertex &end(SortedEdge edge) const { return m_vertices[edgeEnds[std::size_t(edge)][1]]; }

private:
    Quantity cell(std::size_t index) const
    {
        return index < m_setUp.cells.size() ? m_setUp.cells[index] : Quantity();
    }

    SetUpRecord m_setUp;
    std::array<Vertex, 3> m_vertices;
};

} // namespace pixelplumb
