// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"

#include <array>
#include <optional>

namespace pixelplumb {

/// One extreme of what rounding may do to a picture.
struct RoundingSide {
    /// The least exact arithmetic that programs may compute in; exact: only samples on an edge are
    /// open.
    Arithmetic arithmetic = Arithmetic::Float32;
    bool isOutward = false; ///< draws samples closer to a bound than a program errs
    bool isUpward = false; ///< has the greatest levels that a program may have, otherwise the least
};

/// The four sides in the order of PictureRange.
constexpr std::array<RoundingSide, 4> roundingSides(Arithmetic arithmetic)
{
    return {{{arithmetic, false, false},
             {arithmetic, false, true},
             {arithmetic, true, false},
             {arithmetic, true, true}}};
}

/// What programs draw that do the same thing, right or wrong, with different rounding: all their
/// pictures lie between those of the four sides (roundingSides).
struct PictureRange {
    std::array<Picture, 4> sides;
    /// Covered where a sample lies on an edge that the leeway leaves open; none: no leeway.
    std::optional<Picture> openEdges = {};

    /// Whether one of these programs may have the pixel found there; any colour is possible where
    /// it is open whether the pixel is drawn.
    bool contains(const Picture &found, std::size_t place) const;
};

} // namespace pixelplumb
