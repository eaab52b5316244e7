// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

namespace pixelplumb {

/// Mistakes in which samples of a triangle a program goes through, and how it steps between them:
/// ends of spans, halves of the triangle, its box. What they leave of a triangle keeps the kernel's
/// own bytes; samples beyond it have those of the exact colour plane there. None where the scene
/// has more than triangles without effects.
std::vector<Defect> spanDefectsFor(const Scene &scene);

/// The same of a scene of lines: ends, octants, ties.
std::vector<Defect> lineDefectsFor(const Scene &scene);

} // namespace pixelplumb
