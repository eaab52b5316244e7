// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

#include <QString>

namespace pixelplumb {

/// The most triangles that all of a scene's solids together may be cut into: the memory they need
/// is reported before it is allocated.
inline constexpr std::size_t mostSolidTriangles = std::size_t(1) << 21;
inline constexpr int mostSegments = 1024;
/// The most vertices of a scene's lines, curves, polygons, points and texts: drawing takes some
/// 0.5 KiB of memory for each.
inline constexpr std::size_t mostShapeVertices = std::size_t(1) << 21;
/// As many as a character of a text counts, for its outlines: they take some 10 KiB.
inline constexpr std::size_t verticesOfCharacter = 20;

/// The triangles before clipping, which adds some.
std::size_t triangleCount(const Solid &solid);

/// What messages report of too many, and what they ask for instead.
QString tooManyTriangles(std::size_t count);
QString fewerTriangles();
QString tooManyVertices(std::size_t count);
QString fewerVertices();

} // namespace pixelplumb
