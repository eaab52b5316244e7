// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/scene/sceneprojection.h"
#include "core/space/surfaces.h"

namespace pixelplumb {

/// What a number of segments costs, and what it buys.
struct SegmentFigure {
    std::array<int, 2> segments = {};
    std::size_t faces = 0;
    double distance = 0; ///< the largest between faces and surface, in the scene's unit
    double time = 0; ///< of projecting the solid alone, ns: the least of three
};

/// The scene's first sphere or patch; a sphere of radius 1 about the origin where it has none.
Solid studiedSolid(const Scene &scene);
/// The scene's first line, circle, plane or sphere, or an example.
Surface surfaceOf(SurfaceKind kind, const Scene &scene);

/// Segments from 4 × 2 to 128 × 64, and the solid's own, ascending; empty when the listener ends
/// it.
std::vector<SegmentFigure> studySegments(const Solid &solid, const Scene &scene,
                                         const ProgressListener &listener);

} // namespace pixelplumb
