// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/walkcorners.h"

namespace pixelplumb {

/// At which spans a program begins and ends a triangle and its halves.
class WalkedEnds {
public:
    WalkedEnds(const WalkCorners &corners, const WalkedProgram &program, Interval columns)
        : m_corners(corners)
        , m_program(program)
        , m_columns(columns)
    {
    }

    std::int64_t firstOfTriangle() const
    {
        if (!isByRule())
            return spanOf(m_corners.p0());
        const Lattice x = m_corners.p0().position.x;
        const std::int64_t byRule = firstSampleFrom(x, m_columns);
        switch (m_program.firstEnd()) {
        case SpanEnd::ByRule:
            break;
        case SpanEnd::Outward:
            return floorPixel(x);
        case SpanEnd::Nearest:
            return m_program.spanOf(x, EndRounding::Nearest);
        case SpanEnd::OneMore:
            return byRule - 1;
        case SpanEnd::AtZero:
            return 0;
        }
        return byRule;
    }
    std::int64_t endOfTriangle() const
    {
        const Interval columns = m_columns;
        const std::int64_t behind = ownsLast(columns) ? 1 : 0;
        if (!isByRule())
            return spanOf(m_corners.p2()) + behind;
        const Lattice x = m_corners.p2().position.x;
        switch (m_program.lastEnd()) {
        case SpanEnd::ByRule:
            break;
        case SpanEnd::Outward:
            return ceilPixel(x) + behind;
        case SpanEnd::Nearest:
            return m_program.spanOf(x, EndRounding::Nearest) + behind;
        case SpanEnd::OneMore:
            return endSampleAt(x, columns) + 1;
        case SpanEnd::AtZero:
            return 1;
        }
        return endSampleAt(x, columns);
    }
    /// Without a first half the second one begins with the triangle.
    bool isBegunBeforeMiddle() const
    {
        return !m_corners.hasFirstHalf() && m_program.firstEnd() != SpanEnd::ByRule;
    }

    std::int64_t firstOfSecondHalf() const
    {
        if (isByRule() && m_program.bugs().middleSpan == MiddleSpan::FromSpanBefore)
            return floorPixel(m_corners.p1().position.x);
        if (isByRule() && m_program.bugs().middleSpan == MiddleSpan::FromNearest)
            return m_program.spanOf(m_corners.p1().position.x, EndRounding::Nearest);
        return spanOf(m_corners.p1());
    }
    std::int64_t endOfFirstHalf() const
    {
        if (isBegunBeforeMiddle())
            return firstOfTriangle();
        if (m_program.bugs().middleSpan != MiddleSpan::InBothHalves)
            return firstOfSecondHalf();
        return (isByRule() ? floorPixel(m_corners.p1().position.x) : spanOf(m_corners.p1())) + 1;
    }

private:
    std::int64_t spanOf(const Vertex &vertex) const { return m_program.spanOf(vertex.position.x); }
    bool isByRule() const { return m_program.bugs().spans == EndRounding::ByRule; }

    const WalkCorners &m_corners;
    const WalkedProgram &m_program;
    Interval m_columns; ///< which of the outermost spans the fill rule includes
};

} // namespace pixelplumb
