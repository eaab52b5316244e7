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
    /// Of the vertices where its plane has a horizon, beyond which no area is drawn; else zeros.
    std::array<Attribute, 3> w = {};
};

/// How two triangles stand to each other where both are.
enum class PlaneOrder : std::uint8_t {
    Apart, ///< no point belongs to both
    NotBehind, ///< where they overlap, the later one is nearer or as near
    Behind, ///< somewhere where they overlap, the later one is farther
};

/// Of triangles that have area. Exact, of all points and not only of the samples: the difference of
/// two planes is largest at a corner of the polygon in which the triangles overlap. Under the
/// closed rule edges and corners that touch overlap; under the others no sample of theirs has two
/// owners.
PlaneOrder planeOrderOf(const DepthTriangle &earlier, const DepthTriangle &later, FillRule rule);

} // namespace pixelplumb
