// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/visitedsamples.h"

namespace pixelplumb {

namespace {

bool mayBeSeen(const SpanPlace &place, const SampleBox &seen)
{
    switch (place.axis) {
    case SpanAxis::Column:
        return place.coordinate >= seen.firstX && place.coordinate < seen.endX;
    case SpanAxis::Row:
        return place.coordinate >= seen.firstY && place.coordinate < seen.endY;
    case SpanAxis::Free:
        break;
    }
    return true;
}

} // namespace

void visitSamples(const LayerMoment &moment, const std::function<void(const SampleRecord &)> &visit)
{
    const ScanTrace &trace = moment.trace();
    const SampleBox seen = moment.seen();
    const std::size_t done = trace.samplesDoneAt(moment.view.position);
    const std::size_t end = trace.endSpanOf(moment.primitive);
    for (std::size_t span = trace.firstSpanOf(moment.primitive); span < end; ++span) {
        const std::size_t first = trace.firstSampleOf(span);
        if (first >= done)
            break;
        if (!mayBeSeen(trace.placeOf(span), seen))
            continue;
        std::size_t left = done - first;
        for (const SampleRecord &sample : trace.samples(span)) {
            if (left-- == 0)
                break;
            if (sample.x >= seen.firstX && sample.x < seen.endX && sample.y >= seen.firstY
                && sample.y < seen.endY)
                visit(sample);
        }
    }
}

} // namespace pixelplumb
