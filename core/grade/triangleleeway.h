// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/arithmeticbound.h"

namespace pixelplumb {

/// What a right program may draw of one triangle under any fill rule: at a sample on an edge,
/// whether it is drawn is open, but not its colour. In floats the same holds for samples closer to
/// an edge than the rounding error, and a level may be off by the rounding error (ArithmeticBound);
/// in another arithmetic, and for vertices beyond 2^16 px, nothing is rounded. For a triangle
/// without area the samples of its segment are open, and so are their levels between those of its
/// vertices.
class TriangleLeeway {
public:
    TriangleLeeway(const Triangle &triangle, Arithmetic arithmetic, ByteRounding rounding);

    /// The frame's samples that may be drawn.
    SampleBox reachIn(const FrameSpec &frame) const;
    Containment containmentOf(std::int64_t x, std::int64_t y) const;
    /// Whether a drawn sample may have this colour.
    bool mayHave(const Colour &colour, std::int64_t x, std::int64_t y) const;

private:
    bool mayBeOfSegment(std::int64_t x, std::int64_t y) const;

    Triangle m_triangle;
    ByteRounding m_rounding;
    bool m_hasArea = false;
    std::optional<ArithmeticBound> m_bound; ///< none: exact
};

} // namespace pixelplumb
