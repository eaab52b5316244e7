// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

namespace pixelplumb {

/// Mistakes in how lines, circles and polygons are read before the method draws them: ends, radii,
/// contours; and those of redrawnShapeDefectsFor(). None where a scene has triangles or needs more
/// than colours.
std::vector<Defect> shapeDefectsFor(const Scene &scene);

/// Circles of which some arcs are left out, and polygons without an edge.
std::vector<Defect> redrawnShapeDefectsFor(const Scene &scene);

} // namespace pixelplumb
