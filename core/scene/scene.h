// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/shape.h"
#include "core/number/jobprogress.h"
#include "core/scan/boundaryrule.h"
#include "core/scene/hiddenprimitive.h"
#include "core/scene/motion.h"
#include "core/space/solid.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelplumb {

/// What the user made: a frame, the primitives in it, drawn in order, and the method that draws
/// them; the method skips kinds that it does not draw.
/// Coordinates are the scene's own: y points up or down as the frame's origin says; with
/// PixelCentre::Half they are as the user entered them, and primitivesOnSamples() shifts them so
/// that kernels always sample at integers.
struct Scene {
    FrameSpec frame;
    ScanSettings settings;
    std::string method = "column-scan"; ///< id of a row in the table of methods
    std::vector<Triangle> triangles;
    std::vector<Shape> shapes; ///< drawn after the triangles and the solids
    std::vector<TriangleAttributes> attributes; ///< of the triangles; sparse, ascending
    std::optional<Camera> camera; ///< sees the solids; present where there are any
    std::vector<Solid> solids; ///< drawn after the triangles
    Appearance appearance;
    HiddenPrimitives hidden; ///< kept but not drawn
    std::optional<Motion> motion; ///< of the triangles and shapes, stored as at frame 0

    bool hasSolids() const; ///< that are drawn
    /// Its own triangles, or those of solids.
    bool hasTriangles() const { return !triangles.empty() || hasSolids(); }
    std::size_t hiddenCount() const; ///< primitives and solids
    bool isEmpty() const { return !hasTriangles() && shapes.empty(); }

    friend bool operator==(const Scene &, const Scene &) = default;
};

/// Whether the scene has anything that may need more than colours. Most scenes have not, and skip
/// the closer check.
bool mayCallForEffects(const Scene &scene);

/// The scene's primitives in sample coordinates: pixel (x, y) is the sample at (x, y).
Primitives primitivesOnSamples(const Scene &scene);
/// Like primitivesOnSamples(scene), but none where the listener ended it; the listener hears how
/// many faces of solids are projected.
std::optional<Primitives> primitivesOnSamples(const Scene &scene, const ProgressListener &listener);

/// The scene's fill rule for sample coordinates, oriented by its frame.
BoundaryRule boundaryRuleOf(const Scene &scene);

} // namespace pixelplumb
