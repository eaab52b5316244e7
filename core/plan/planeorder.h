// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/triangle.h"
#include "core/scan/scansettings.h"

#include <array>

namespace pixelplumb {

/// A triangle with the depths of its vertices.
struct DepthTriangle {
    const Triangle *triangle = nullptr;
    std::array<Attribute, 3> z = {};
    /// The vertices' w where the plane has a horizon, beyond which no area is drawn; else zeros.
    std::array<Attribute, 3> w = {};
};

/// The depth order of two triangles where they overlap.
enum class PlaneOrder : std::uint8_t {
    Apart, ///< no point belongs to both
    NotBehind, ///< where they overlap, the later one is at least as near
    Behind, ///< at some point of the overlap the later one is farther
};

/// For triangles with area. Exact, for all points and not only the samples: the difference of two
/// planes is largest at a corner of the polygon in which the triangles overlap. Under the closed
/// rule touching edges and corners overlap; under the others no sample there has two owners.
PlaneOrder planeOrderOf(const DepthTriangle &earlier, const DepthTriangle &later, FillRule rule);

} // namespace pixelplumb
