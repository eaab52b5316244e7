// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenesformethods.h"

namespace pixelplumb {

/// Lines that are steep, fall or are given backwards, points, curves, polygons and triangles of all
/// forms, cut by their frame on all sides.
Scene sceneCutByItsFrame();

/// A triangle whose vertices carry z, u, v and normals that call for no effect.
Scene sceneThatCarriesNumbers();

/// The middles of the examples that call for effects, some of them with antialiasing as well, and
/// textures with four texels a sample.
std::vector<NamedScene> scenesWithEffects();

/// A scene on which each variant of the method departs from the right picture.
Scene departingScene(const Method &method);

} // namespace pixelplumb
