// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/beziernumbers.h"
#include "core/methods/curves/flatrecording.h"

namespace pixelplumb {

struct BezierRecording : BezierNumbers, FlatRecording {
    static const auto &setUpNumbers() { return bezierSetUpNumbers(); }
    static const auto &spanNumbers() { return bezierNumbers(); }

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
};

} // namespace pixelplumb
