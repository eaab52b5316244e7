// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/arithmeticbound.h"
#include "core/grade/picturerange.h"

namespace pixelplumb {

/// What a walk in float64 adds to its numbers to stand on a side of what rounding may do to them:
/// its own error and that of the other program, as a right walk's are bounded
/// (resources/numerics.md, 3.9). Nothing by default.
class WalkSide {
public:
    WalkSide() = default;
    WalkSide(const Triangle &triangle, const RoundingSide &side);

    /// To y_B, and from y_T, px.
    double inward() const;
    /// To the levels of a column by what they grow from sample to sample, and by its height, px.
    double upward(double rate, double height) const;
    /// To the levels that the next column goes on with, where R is not begun there anew; of a thin
    /// span, whose increment may be anything, nothing is known, and nothing added.
    double carriedUpward(double rate, double height) const;

private:
    bool isThin(double height) const;

    RoundingSide m_side;
    std::optional<ArithmeticBound> m_bound; ///< none: nobody knows
};

} // namespace pixelplumb
