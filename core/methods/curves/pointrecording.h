// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/curvenumbers.h"
#include "core/methods/curves/flatrecording.h"

namespace pixelplumb {

struct PointRecording : PointNumbers, FlatRecording {
    static const auto &setUpNumbers() { return pointSetUpNumbers(); }
    static const auto &spanNumbers() { return pointNumbers(); }

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
};

} // namespace pixelplumb
