// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/arithmeticbound.h"
#include "core/grade/picturerange.h"

namespace pixelplumb {

/// What a walk in float64 adds to its numbers to reach a side of rounding: its own error and that
/// of the other program, as bounded for a right walk (resources/numerics.md, 3.9). Nothing by
/// default.
class WalkSide {
public:
    WalkSide() = default;
    WalkSide(const Triangle &triangle, const RoundingSide &side);

    /// Added to y_B and subtracted from y_T, px.
    double inward() const;
    /// Added to a column's levels, which change by `rate` from sample to sample; `height` is the
    /// column's, px.
    double upward(double rate, double height) const;
    /// Added to the levels with which the next column goes on if R is not restarted there. Nothing
    /// for a thin span: its increment may be anything, so no bound is known.
    double carriedUpward(double rate, double height) const;

private:
    bool isThin(double height) const;

    RoundingSide m_side;
    std::optional<ArithmeticBound> m_bound; ///< none: unknown
};

} // namespace pixelplumb
