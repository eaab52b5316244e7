// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/sceneprojection.h"

#include <map>
#include <set>

namespace pixelplumb {

/// A scene of 100 × 80 pixels, viewed from (0, 0, 5) towards the origin, depths 1 to 100.
Scene sceneOf(std::vector<Solid> solids);

SolidCorner cornerAt(const Vector3 &position);
Solid triangle3(const Vector3 &a, const Vector3 &b, const Vector3 &c);

/// A sphere, a patch or a closed mesh (a tilted, displaced octahedron), of radius 1 about the
/// origin.
Solid solidOf(SolidKind kind);

/// The distance (px) of a point of the frame from the nearest triangle; 0 inside one.
double distanceFrom(const std::vector<Triangle> &triangles, double x, double y);

/// Twice the area of a triangle in the xy plane, in px² of an orthographic view of height 4 in 80
/// rows.
double doubledAreaInPixels(const Vector3 &a, const Vector3 &b, const Vector3 &c);

/// How often each directed edge occurs, minus how often its reverse does; empty if every edge has
/// its partner.
std::map<std::pair<LatticePoint, LatticePoint>, int> openEdges(
    const std::vector<Triangle> &triangles);

/// The frame positions of a patch's rim, clipped or not; empty for a closed solid.
std::set<LatticePoint> bordersOf(const Solid &solid, const Scene &scene);

} // namespace pixelplumb
