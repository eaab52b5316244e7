// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/effectplan.h"

namespace pixelplumb {

/// The plan of what each triangle has by itself; effects that change no pixel are not left out.
/// Depth and antialiasing are as the appearance says, with DepthUse::Auto meaning on.
EffectPlan planByHand(const Primitives &primitives);

} // namespace pixelplumb
