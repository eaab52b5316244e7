// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/shadeddrawing.h"

#include <optional>

namespace pixelplumb {

/// Draws as drawShaded() does and counts the work of effects, by the kernels that take all their
/// effects when they run, in any numbers. None where the listener ended it.
std::optional<EffectTally> drawCounted(ShadedMethod method, const Primitives &primitives,
                                       const ScanSettings &settings, FrameView frame,
                                       const EffectPlan &plan, const ProgressListener &listener);

} // namespace pixelplumb
