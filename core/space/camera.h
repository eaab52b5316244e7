// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace pixelplumb {

/// A point or direction in the scene's space (right-handed, y up), as its file gives it.
using Vector3 = std::array<double, 3>;

enum class Projection : std::uint8_t { Perspective, Orthographic };

/// The camera that a scene's solids are seen through (Triangle Rasterization slides, "Projection of
/// points", "Projection of triangles"; Scan Conversion slides, "Projective Rendering Pipeline").
struct Camera {
    Projection projection = Projection::Perspective;
    Vector3 eye = {0, 0, 5};
    Vector3 target = {0, 0, 0};
    Vector3 up = {0, 1, 0};
    double fieldOfView = 60; ///< of a perspective: the vertical angle in degrees, > 0 and < 180
    double height = 4; ///< of an orthographic projection: the height that the frame shows, > 0
    double near = 1; ///< distance of the near plane from the eye, > 0; z = 0 there
    double far = 100; ///< > near; z = 1 there

    friend bool operator==(const Camera &, const Camera &) = default;
};

} // namespace pixelplumb
