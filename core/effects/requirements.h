// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/depthquestion.h"

namespace pixelplumb {

/// The antialiasing that is asked for: what the appearance says, and what was forced on or off.
Antialiasing antialiasingOf(const Appearance &appearance);

/// That which runs for the triangles and for the lines and curves: none where it changes nothing,
/// because no edge of what is drawn meets a pixel of the frame, and nobody forces it on.
Antialiasing triangleAntialiasing(const Primitives &primitives, const ScanSettings &settings,
                                  const FrameView &frame);
Antialiasing strokeAntialiasing(const Primitives &primitives, const FrameView &frame);

/// requirementsOf, where the question of depth was answered already.
PerEffect<EffectVerdict> requirementsWith(const Primitives &primitives,
                                          const ScanSettings &settings, const SampledFrame &where,
                                          const DepthAnswer &depth);

} // namespace pixelplumb
