// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/depthquestion.h"

namespace pixelplumb {

/// The antialiasing that runs: what the appearance says, and what was forced on or off.
Antialiasing antialiasingOf(const Appearance &appearance);

/// requirementsOf, where the question of depth was answered already.
PerEffect<EffectVerdict> requirementsWith(const Primitives &primitives,
                                          const ScanSettings &settings, const FrameView &frame,
                                          const DepthAnswer &depth);

} // namespace pixelplumb
