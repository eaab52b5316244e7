// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/arithmeticbound.h"

namespace pixelplumb {

/// What a right program may draw of one triangle, whichever fill rule it follows: of a sample on an
/// edge it is open whether, not in which colour. In floats the same holds of samples nearer to an
/// edge than rounding errs, and a level may be off by what rounding errs (ArithmeticBound); in
/// another arithmetic, and of vertices beyond 2^16 px, nothing is rounded. Of a triangle without
/// area the samples of its segment are open, and so is which of the levels between its vertices'
/// they have.
class TriangleLeeway {
public:
    TriangleLeeway(const Triangle &triangle, Arithmetic arithmetic, ByteRounding rounding);

    /// The samples of the frame that may be drawn.
    SampleBox reachIn(const FrameSpec &frame) const;
    Containment containmentOf(std::int64_t x, std::int64_t y) const;
    /// Whether a sample that is drawn may have this colour.
    bool mayHave(const Colour &colour, std::int64_t x, std::int64_t y) const;

private:
    bool mayBeOfSegment(std::int64_t x, std::int64_t y) const;

    Triangle m_triangle;
    ByteRounding m_rounding;
    bool m_hasArea = false;
    std::optional<ArithmeticBound> m_bound; ///< none: exact
};

} // namespace pixelplumb
