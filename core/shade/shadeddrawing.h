// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/shade/effectwork.h"
#include "core/shade/shadedchoice.h"

#include <optional>

namespace pixelplumb {

/// Draws the triangles by the plan, each batch by the stages that it calls for, and counts their
/// work. The method must support shading in the settings' arithmetic. Before each triangle the
/// listener gets the number drawn; with 4 or 16 samples a triangle counts once more for each. None
/// if the listener ended it.
std::optional<EffectTally> drawShaded(ShadedMethod method, const Primitives &primitives,
                                      const ScanSettings &settings, FrameView frame,
                                      const EffectPlan &plan,
                                      const ProgressListener &listener = {});

} // namespace pixelplumb
