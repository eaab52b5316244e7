// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace pixelplumb {

/// A point or a direction in the scene's space (right-handed, y up), as its file says it.
using Vector3 = std::array<double, 3>;

enum class Projection : std::uint8_t { Perspective, Orthographic };

/// Through what a scene's solids are seen (Triangle Rasterization slides, "Projection of points",
/// "Projection of triangles"; Scan Conversion slides, "Projective Rendering Pipeline").
struct Camera {
    Projection projection = Projection::Perspective;
    Vector3 eye = {0, 0, 5};
    Vector3 target = {0, 0, 0};
    Vector3 up = {0, 1, 0};
    double fieldOfView = 60; ///< of a perspective: the vertical angle, degrees, > 0 and < 180
    double height = 4; ///< of an orthographic one: what the frame's height shows, > 0
    double near = 1; ///< > 0, the distance of the near plane from the eye; z = 0 there
    double far = 100; ///< > near; z = 1 there

    friend bool operator==(const Camera &, const Camera &) = default;
};

} // namespace pixelplumb
