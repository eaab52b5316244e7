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

/// What a person made: a frame, the primitives in it, drawn in order, and the method to draw them
/// with, which passes over those that are not of its kinds.
/// Coordinates are the scene's own: y upward or downward as the frame's origin says; with
/// PixelCentre::Half they are where the person put them, and primitivesOnSamples() shifts them so
/// that kernels always sample at integers.
struct Scene {
    FrameSpec frame;
    ScanSettings settings;
    std::string method = "column-scan"; ///< id of a row of the table of methods
    std::vector<Triangle> triangles;
    std::vector<Shape> shapes; ///< drawn after the triangles and the solids
    std::vector<TriangleAttributes> attributes; ///< of the triangles; sparse, ascending
    std::optional<Camera> camera; ///< through which the solids are seen; there where there are any
    std::vector<Solid> solids; ///< drawn after the triangles
    Appearance appearance;
    HiddenPrimitives hidden; ///< kept, and not drawn
    std::optional<Motion> motion; ///< of the triangles and shapes, which stand as at frame 0

    bool hasSolids() const; ///< that are drawn
    /// Of its own, or of solids.
    bool hasTriangles() const { return !triangles.empty() || hasSolids(); }
    std::size_t hiddenCount() const; ///< of primitives and solids
    bool isEmpty() const { return !hasTriangles() && shapes.empty(); }

    friend bool operator==(const Scene &, const Scene &) = default;
};

/// Whether the scene has anything for which more than colour may be called: most have not, and are
/// not asked what they need.
bool mayCallForEffects(const Scene &scene);

/// The scene's primitives in sample coordinates: pixel (x, y) is the sample at (x, y).
Primitives primitivesOnSamples(const Scene &scene);
/// None where the listener, who hears of solids how many faces are projected, ended it.
std::optional<Primitives> primitivesOnSamples(const Scene &scene, const ProgressListener &listener);

/// The scene's fill rule as its frame sees it, for sample coordinates.
BoundaryRule boundaryRuleOf(const Scene &scene);

} // namespace pixelplumb
