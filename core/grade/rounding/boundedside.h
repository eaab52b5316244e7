// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picturerange.h"
#include "core/grade/rounding/arithmeticbound.h"
#include "core/scan/mistakes/walkside.h"

namespace pixelplumb {

/// A side of rounding: its own error and that of the other program, as bounded for a right walk
/// (resources/numerics.md, 3.9).
class BoundedSide final : public WalkSide {
public:
    BoundedSide(const Triangle &triangle, const RoundingSide &side);

    double inward() const override;
    double upward(double rate, double height) const override;
    /// Nothing for a thin span: its increment may be anything, so no bound is known.
    double carriedUpward(double rate, double height) const override;

private:
    bool isThin(double height) const;

    RoundingSide m_side;
    std::optional<ArithmeticBound> m_bound; ///< none: unknown
};

} // namespace pixelplumb
