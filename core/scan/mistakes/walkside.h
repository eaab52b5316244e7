// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// What a walk in float64 adds to its numbers to reach a side of what rounding may do; by default
/// nothing.
class WalkSide {
public:
    virtual ~WalkSide() = default;

    /// Added to y_B and subtracted from y_T, px.
    virtual double inward() const { return 0; }
    /// Added to a column's levels, which change by `rate` from sample to sample; `height` is the
    /// column's, px.
    virtual double upward(double, double) const { return 0; }
    /// Added to the levels with which the next column goes on if R is not restarted there.
    virtual double carriedUpward(double, double) const { return 0; }
};

} // namespace pixelplumb
