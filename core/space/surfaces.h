// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/facestages.h"

namespace pixelplumb {

/// Curves and surfaces that have all three forms (Scan Conversion slides, "Lines and Curves:
/// Explicit", "Lines and Curves: Parametric", "Lines and Curves: Implicit").
enum class SurfaceKind : std::uint8_t { Line, Circle, Plane, Sphere };
inline constexpr std::array allSurfaces
    = {SurfaceKind::Line, SurfaceKind::Circle, SurfaceKind::Plane, SurfaceKind::Sphere};

QString nameOf(SurfaceKind kind); ///< "line", …

/// A curve or surface: a line through the first two points or a circle about the first one, both in
/// the xy plane; a plane through three points; a sphere about the first.
struct Surface {
    SurfaceKind kind = SurfaceKind::Line;
    std::array<Vector3, 3> points = {};
    double radius = 1;
};

/// One form, evaluated at a point.
struct SurfaceForm {
    QString name; ///< "explicit", "parametric", "implicit"
    QString formula; ///< "y = m·x + b"
    QString note; ///< what the form is good for, or where it fails: "m is infinite here"
    /// The parametric form gives the point, the explicit form its last coordinate from the others,
    /// the implicit form 0 up to rounding.
    std::vector<StageNumber> numbers;
};

/// The three forms at parameters s and t in 0 … 1; curves use only s.
std::vector<SurfaceForm> formsOf(const Surface &surface, double s, double t);

/// The largest distance between a sphere and its faces, in the unit of its radius, by a formula:
/// each row's faces are nearest to the centre on their middle line.
double sphereDistance(double radius, const std::array<int, 2> &segments);

/// The largest distance between a patch's triangles and the patch at the same parameters, over a
/// grid of samples in each cell. The distance to the surface itself is no larger there.
double patchDistance(const Solid &patch);

} // namespace pixelplumb
