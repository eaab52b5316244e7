// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layermoment.h"

#include <functional>

namespace pixelplumb {

/// Passes to a function the samples in view that the method has visited for the primitive, up to
/// the current step, with the numbers that it used there.
void visitSamples(const LayerMoment &moment,
                  const std::function<void(const SampleRecord &)> &visit);

} // namespace pixelplumb
