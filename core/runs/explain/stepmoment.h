// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/words/pseudocode.h"

namespace pixelplumb {

class ScanTrace;
struct TracedScene;

/// The step with an index in 0 … stepCount() − 1 as a moment of its method's pseudocode: the lines
/// that list it are what the step does.
Moment momentOf(const ScanTrace &trace, std::size_t stepIndex);

/// The lines that run for a primitive under the scene's variants and fill rule: of effects, only
/// those of its batch.
Pseudocode pseudocodeOf(const TracedScene &traced, std::size_t primitive);

} // namespace pixelplumb
