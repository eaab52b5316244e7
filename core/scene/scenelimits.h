// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

#include <QString>

namespace pixelplumb {

/// Into how many triangles a scene's solids may be cut, all together: what they take in memory is
/// said before it is taken.
inline constexpr std::size_t mostSolidTriangles = std::size_t(1) << 21;
inline constexpr int mostSegments = 1024;
/// Vertices of the lines, curves, polygons and points of a scene, and characters of its texts, all
/// together: drawing them takes some 0.5 KiB of memory for each.
inline constexpr std::size_t mostShapeVertices = std::size_t(1) << 21;

/// Before clipping, which adds some.
std::size_t triangleCount(const Solid &solid);

/// What messages say of too many, and what they ask for.
QString tooManyTriangles(std::size_t count);
QString fewerTriangles();
QString tooManyVertices(std::size_t count);
QString fewerVertices();

} // namespace pixelplumb
