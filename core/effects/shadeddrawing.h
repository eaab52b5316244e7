// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/effectwork.h"
#include "core/effects/shadedchoice.h"
#include "core/number/jobprogress.h"

#include <optional>

namespace pixelplumb {

/// Draws the triangles as the plan says, each batch by the stages that it calls for, and counts
/// what they do. The settings' arithmetic is one that the method shades in. None where the
/// listener, who hears before each triangle how many are drawn, ended it; with 4 or 16 samples a
/// triangle counts once more for each.
std::optional<EffectTally> drawShaded(ShadedMethod method, const Primitives &primitives,
                                      const ScanSettings &settings, FrameView frame,
                                      const EffectPlan &plan,
                                      const ProgressListener &listener = {});

} // namespace pixelplumb
