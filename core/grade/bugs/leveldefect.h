// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

namespace pixelplumb {

/// Mistakes in how a level of 0 … 1 becomes a byte: a factor other than 255. None where the scene
/// cannot be redrawn.
std::vector<Defect> levelDefectsFor(const Scene &scene);

} // namespace pixelplumb
