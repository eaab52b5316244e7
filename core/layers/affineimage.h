// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"

#include <array>
#include <cstddef>

namespace pixelplumb {

using Corners = std::array<LatticePoint, 3>;

/// Where an affine map takes the corners of a triangle of a run, in the user's order and in the
/// scene's coordinates: three corners and their images define a map.
struct AffineImage {
    std::size_t triangle = 0;
    Corners corners;

    friend bool operator==(const AffineImage &, const AffineImage &) = default;
};

} // namespace pixelplumb
