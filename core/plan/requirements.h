// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/depthquestion.h"

namespace pixelplumb {

/// The requested antialiasing: the appearance's, unless forced on or off.
Antialiasing antialiasingOf(const Appearance &appearance);

/// The antialiasing that runs for triangles, and for lines and curves: none where it changes
/// nothing, because no drawn edge meets a pixel of the frame, and it is not forced on.
Antialiasing triangleAntialiasing(const Primitives &primitives, const ScanSettings &settings,
                                  const FrameView &frame);
Antialiasing strokeAntialiasing(const Primitives &primitives, const FrameView &frame);

/// requirementsOf() where the depth question is already answered.
PerEffect<EffectVerdict> requirementsWith(const Primitives &primitives, const SampledFrame &where,
                                          const DepthAnswer &depth);

} // namespace pixelplumb
