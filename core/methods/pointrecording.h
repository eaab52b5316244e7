// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/flatrecording.h"
#include "core/scan/pointaddress.h"

namespace pixelplumb {

struct PointRecording : PointNumbers, FlatRecording {
    using FlatRecording::record;

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.cells = {Quantity::integer(setUp.width), Quantity::integer(setUp.firstColumn),
                        Quantity::integer(setUp.firstRow)};
    }
    static void record(const Span &step, SpanRecord &record)
    {
        record.cells
            = {Quantity::integer(step.number), Quantity::integer(step.x), Quantity::integer(step.y),
               step.isInFrame ? Quantity::integer(step.address) : Quantity()};
    }
};

} // namespace pixelplumb
