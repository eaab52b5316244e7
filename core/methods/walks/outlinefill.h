// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"
#include "core/methods/walks/outlinefillrecording.h"

namespace pixelplumb {

struct OutlineFillKernel : TriangleKernel, InIntegers {
    template <class A>
    using Recording = OutlineFillRecording<A>;

    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        fillOutline<A>(triangle, settings.rounding, frame, observer);
    }
};

} // namespace pixelplumb
