// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/sceneprojection.h"

#include <map>
#include <set>

namespace pixelplumb {

/// A scene of 100 × 80 pixels, seen from (0, 0, 5) towards the origin, from depth 1 to 100.
Scene sceneOf(std::vector<Solid> solids);

SolidCorner cornerAt(const Vector3 &position);
Solid triangle3(const Vector3 &a, const Vector3 &b, const Vector3 &c);

/// A sphere, a patch or a closed mesh (an octahedron, placed askew), of radius 1 about the origin.
Solid solidOf(SolidKind kind);

/// How far a point of the frame (px) lies from the nearest of the triangles; 0 inside one.
double distanceFrom(const std::vector<Triangle> &triangles, double x, double y);

/// Twice the area of a triangle in the plane of x and y, in px² of an orthographic view of height 4
/// in 80 rows.
double doubledAreaInPixels(const Vector3 &a, const Vector3 &b, const Vector3 &c);

/// How often each directed edge is there, less how often its reverse is: nothing where every edge
/// has its partner.
std::map<std::pair<LatticePoint, LatticePoint>, int> openEdges(
    const std::vector<Triangle> &triangles);

/// The places in the frame of a patch's rim, cut or not; nothing of a closed solid.
std::set<LatticePoint> bordersOf(const Solid &solid, const Scene &scene);

} // namespace pixelplumb
