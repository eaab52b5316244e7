// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

#include <QString>

namespace pixelplumb {

/// Into how many triangles a scene's solids may be cut, all together: what they take in memory is
/// said before it is taken.
inline constexpr std::size_t mostSolidTriangles = std::size_t(1) << 21;
inline constexpr int mostSegments = 1024;

/// Before clipping, which adds some.
std::size_t triangleCount(const Solid &solid);

/// What messages say of too many, and what they ask for.
QString tooManyTriangles(std::size_t count);
QString fewerTriangles();

} // namespace pixelplumb
