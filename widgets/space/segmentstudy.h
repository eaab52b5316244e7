// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/scene/sceneprojection.h"
#include "core/space/surfaces.h"

#include <optional>

namespace pixelplumb {

/// The cost and the benefit of a number of segments.
struct SegmentFigure {
    std::array<int, 2> segments = {};
    std::size_t faces = 0;
    double distance = 0; ///< the largest between faces and surface, in scene units
    double time = 0; ///< processor time to project the solid alone, ns: the least of three
};

/// The scene's first sphere or patch, if it has one.
std::optional<Solid> studiedSolid(const Scene &scene);
/// The scene's first line, circle, plane or sphere, if it has one.
std::optional<Surface> surfaceOf(SurfaceKind kind, const Scene &scene);

/// Defaults where the scene has none: a sphere of radius 1 about the origin, and one of each kind.
Solid exampleSolid();
Surface exampleOf(SurfaceKind kind);

/// Studies segments from 4 × 2 to 128 × 64, and the solid's own, ascending; empty when the listener
/// cancels.
std::vector<SegmentFigure> studySegments(const Solid &solid, const Scene &scene,
                                         const ProgressListener &listener);

} // namespace pixelplumb
