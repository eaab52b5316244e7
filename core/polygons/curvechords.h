// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

namespace pixelplumb {

/// A closed path of Bézier pieces as a polygon on the lattice, of one contour: each piece a chain
/// of chords that leave it by 1/32 px at most (of pieces that bend by more than 680,000 px, 4096
/// chords), their ends at the nearest lattice points, as those of a glyph are. Where a piece does
/// not begin at the end of the one before, an edge joins them.
Shape chordsOf(const Shape &path);

/// The Bézier pieces of a path.
std::size_t pieceCount(const Shape &path);

} // namespace pixelplumb
