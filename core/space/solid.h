// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/space/camera.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pixelplumb {

/// The kinds of primitives in three dimensions (Rasterization slides, "Output Primitives"; Scan
/// Conversion slides, "Polygons").
enum class SolidKind : std::uint8_t {
    Triangle3, ///< three corners
    Polygon3, ///< three or more corners, convex, in one plane
    Plane, ///< P0, P1, P2: the parallelogram P(s, t) = P0 + s(P1 − P0) + t(P2 − P0), 0 <= s, t <= 1
    Sphere, ///< one corner, the centre; `radius`, `segments` around and from pole to pole
    Patch, ///< 16 control points of a bicubic Bézier patch, row by row; `segments`
    Mesh, ///< the triangles of a file
};

/// A corner of a solid, in the scene's space.
struct SolidCorner {
    Vector3 position = {};
    Colour colour = {{255, 255, 255}};
    std::uint8_t alpha = 255;
    std::array<double, 2> texture = {};
    Vector3 normal = {}; ///< 0: the face's own

    friend bool operator==(const SolidCorner &, const SolidCorner &) = default;
};

/// The triangles of a mesh file, read once.
struct Mesh {
    std::string name; ///< the file, as the scene names it
    std::vector<SolidCorner> corners;
    std::vector<std::array<std::uint32_t, 3>> faces; ///< indices of corners

    friend bool operator==(const Mesh &, const Mesh &) = default;
};

/// A primitive in three dimensions, seen through the scene's camera.
struct Solid {
    SolidKind kind = SolidKind::Triangle3;
    std::vector<SolidCorner> corners;
    double radius = 1; ///< of a sphere
    std::array<int, 2> segments = {16, 8}; ///< of a sphere and a patch
    std::shared_ptr<const Mesh> mesh; ///< of a mesh
    Vector3 at = {}; ///< of a mesh: the position of its origin
    double scale = 1; ///< of a mesh
    Vector3 rotate = {}; ///< of a mesh: degrees about x, then y, then z
    int material = noMaterial;
    /// Of a sphere, patch, plane or mesh; white unless the file says otherwise.
    Colour colour = {{255, 255, 255}};
    std::uint8_t alpha = 255;
    bool isHidden = false; ///< kept but not drawn: it has no faces

    friend bool operator==(const Solid &a, const Solid &b)
    {
        const bool sameMesh = a.mesh == b.mesh || (a.mesh && b.mesh && *a.mesh == *b.mesh);
        return sameMesh && a.kind == b.kind && a.corners == b.corners && a.radius == b.radius
            && a.segments == b.segments && a.at == b.at && a.scale == b.scale
            && a.rotate == b.rotate && a.material == b.material && a.colour == b.colour
            && a.alpha == b.alpha && a.isHidden == b.isHidden;
    }
};

} // namespace pixelplumb
