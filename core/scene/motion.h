// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"

namespace pixelplumb {

struct Scene;

inline constexpr int largestFrameCount = 1000;

/// A motion of everything in the plane, by one vector from the first frame to the last (Scan
/// Conversion slides, "Triangle Rasterization Issues: Moving Slivers").
struct Motion {
    LatticePoint by; ///< lattice units
    int frames = 2; ///< 2 … largestFrameCount

    friend bool operator==(const Motion &, const Motion &) = default;
};

/// The scene at a frame, 0 … frames − 1, without its motion: triangles and shapes moved by
/// by·frame/(frames − 1), each coordinate to the nearest lattice unit, the off-screen point
/// unmoved. A scene without motion stays as it is; a vertex that would leave ±2^30 px stays at that
/// border.
Scene sceneAtFrame(const Scene &scene, int frame);

} // namespace pixelplumb
