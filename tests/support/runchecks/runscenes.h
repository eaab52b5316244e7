// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenes/scenesformethods.h"

namespace pixelplumb {

/// Steep, falling and reversed lines, points, curves, polygons and triangles of all forms, cut by
/// the frame on all sides.
Scene sceneCutByItsFrame();

/// A triangle whose vertices carry z, u, v and normals that require no effect.
Scene sceneThatCarriesNumbers();

/// The middles of the examples that require effects, some also with antialiasing and with bilinear
/// textures (four texels a sample).
std::vector<NamedScene> scenesWithEffects();

/// A scene on which each variant of the method departs from the right picture.
Scene departingScene(const Method &method);

} // namespace pixelplumb
