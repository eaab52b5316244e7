// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

namespace pixelplumb {

/// A closed path of Bézier pieces as a polygon of one contour on the lattice. Each piece becomes a
/// chain of chords that deviate from it by at most 1/32 px (or 4096 chords, for pieces that bend by
/// more than 680,000 px), with ends at the nearest lattice points, as for glyphs. An edge joins
/// pieces that do not meet.
Shape chordsOf(const Shape &path);

/// The number of Bézier pieces of a path.
std::size_t pieceCount(const Shape &path);

} // namespace pixelplumb
