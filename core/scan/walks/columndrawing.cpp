// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/walks/columndrawing.h"

#include "core/scan/kernelnumbers.h"
#include "core/scan/walks/columnscan.h"

namespace pixelplumb {

void drawColumns(std::span<const Triangle> triangles, const ScanSettings &settings, FrameView frame)
{
    for (const Triangle &triangle : triangles) {
        InAnyArithmetic::withNumbers(
            settings, InAnyArithmetic::widthFor(triangle, frame),
            [&]<class A>() { scanColumns<A>(triangle, settings, frame, NullObserver{}); });
    }
}

} // namespace pixelplumb
