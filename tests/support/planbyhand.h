// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/effectplan.h"

namespace pixelplumb {

/// The plan of what each triangle has by itself, without looking for what changes no pixel: depth
/// and antialiasing as the appearance says them, with DepthUse::Auto for on.
EffectPlan planByHand(const Primitives &primitives);

} // namespace pixelplumb
