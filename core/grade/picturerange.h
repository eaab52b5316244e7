// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

#include <array>

namespace pixelplumb {

/// A side of what rounding may do to a picture.
struct RoundingSide {
    /// What errs most of all that programs may compute in; exact: samples on an edge alone are
    /// open.
    Arithmetic arithmetic = Arithmetic::Float32;
    bool isOutward = false; ///< draws what lies at a bound, nearer than a program errs
    bool isUpward = false; ///< has the greatest levels that a program may have, not the least
};

/// The four in the order of PictureRange.
constexpr std::array<RoundingSide, 4> roundingSides(Arithmetic arithmetic)
{
    return {{{arithmetic, false, false},
             {arithmetic, false, true},
             {arithmetic, true, false},
             {arithmetic, true, true}}};
}

/// What is drawn by programs that do the same thing, right or wrong, and round otherwise: the
/// pictures of the four sides (roundingSides), between which all of theirs lie.
struct PictureRange {
    std::array<Picture, 4> sides;

    /// Whether one of them may have what is found there: any colour where it is open whether the
    /// pixel is drawn.
    bool contains(const Picture &found, std::size_t place) const;
};

} // namespace pixelplumb
