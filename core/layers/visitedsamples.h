// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layermoment.h"

#include <functional>

namespace pixelplumb {

/// Shows a function the samples in view that the method has visited of the primitive, up to the
/// step in hand, with the numbers that it used there.
void visitSamples(const LayerMoment &moment,
                  const std::function<void(const SampleRecord &)> &visit);

} // namespace pixelplumb
