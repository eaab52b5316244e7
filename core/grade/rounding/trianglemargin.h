// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/arithmeticbound.h"
#include "core/grade/rounding/margin.h"
#include "core/scene/scene.h"

namespace pixelplumb {

/// The colours between two, channel by channel.
struct ColourRange {
    Colour least, most;

    bool contains(const Colour &colour) const;
};

/// What a right program may draw of one triangle. Whether a sample is drawn is open where rounding
/// decides it, closer to an edge than the rounding error, and a level may be off by the rounding
/// error (ArithmeticBound). On an edge that nothing rounds the fill rule decides, unless the leeway
/// leaves edges open; the colour there is not open. In another arithmetic than float32 and float64
/// nothing is rounded, for vertices beyond 2^16 px edges alone are open. For a triangle
/// without area the samples of its segment are open, and so are their levels between those of its
/// vertices.
class TriangleMargin {
public:
    TriangleMargin(const Triangle &triangle, const Scene &scene, const Margin &margin);

    /// The frame's samples that may be drawn.
    SampleBox reachIn(const FrameSpec &frame) const;
    Containment containmentOf(std::int64_t x, std::int64_t y,
                              ProgramWays ways = allProgramWays) const;
    /// The ways that may decide a sample otherwise than the scene's rule; none where edges are
    /// open.
    ProgramWays deviatingAt(std::int64_t x, std::int64_t y) const
    {
        return m_bound && m_hasArea && m_rule ? m_bound->deviatingAt(x, y, *m_rule) : 0;
    }
    /// Whether all programs that evaluate edge functions draw the sample.
    bool isDrawnByFunctions(std::int64_t x, std::int64_t y) const;
    /// The colours that a drawn sample may have.
    ColourRange coloursAt(std::int64_t x, std::int64_t y) const;
    bool mayHave(const Colour &colour, std::int64_t x, std::int64_t y) const
    {
        return coloursAt(x, y).contains(colour);
    }

private:
    bool mayBeOfSegment(std::int64_t x, std::int64_t y) const;

    Triangle m_triangle;
    ByteRounding m_rounding;
    bool m_hasArea = false;
    std::optional<BoundaryRule> m_rule; ///< none: edges are open
    std::optional<ArithmeticBound> m_bound; ///< none: exact
};

} // namespace pixelplumb
