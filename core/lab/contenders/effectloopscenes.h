// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

/// The scenes on which kernels of effects are measured against straight loops: large triangles, in
/// sample coordinates, that lie inside a frame of effectLoopSide px and call for one set of
/// effects.
namespace pixelplumb::effectscenes {

Primitives deep();
Primitives deepIn24Bits();
Primitives textured();
Primitives filteredAndDeep();
Primitives lit();
Primitives glass();
Primitives sampled();

} // namespace pixelplumb::effectscenes
