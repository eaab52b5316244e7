// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

namespace pixelplumb {

/// Mistakes in which samples of a triangle a program visits, and in how it steps between them: ends
/// of spans, halves of the triangle, its box; and those of a walk along edges (walkDefectsFor).
/// Where samples are only left out or added, the triangle's samples keep the kernel's bytes and
/// added ones have the exact colour plane's. None where the scene has more than triangles without
/// effects.
std::vector<Defect> spanDefectsFor(const Scene &scene);

} // namespace pixelplumb
