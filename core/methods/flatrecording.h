// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/flatpixel.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

/// How the pixels of one colour become records, and what recordings of lattice numbers share.
struct FlatRecording {
    static bool isClamped(const FlatSample &) { return false; }

    static void record(const FlatSample &sample, SampleRecord &record)
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            record.level[channel] = sample.colour.channels[channel];
            record.colour[channel] = Quantity::integer(sample.colour.channels[channel]);
        }
    }

protected:
    static Quantity px(Lattice units) { return Quantity::rational(units, unitsPerPixel); }
    static SpanPlace freeStep(std::int64_t number, int part = 0)
    {
        return {SpanAxis::Free, number, part};
    }
};

} // namespace pixelplumb
