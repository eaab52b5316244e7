// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/openingplace.h"

namespace pixelplumb {

namespace {

/// A third into the first span of the second part; else the middle of the run.
std::size_t halfDrawn(const ScanTrace &trace)
{
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const std::size_t samples = trace.endSampleOf(span) - trace.firstSampleOf(span);
        if (trace.placeOf(span).part == 1 && samples > 0)
            return trace.indexOfSpan(span) + 1 + samples / 3;
    }
    return trace.stepCount() / 2;
}

std::size_t justEntered(std::int64_t x, const ScanTrace &trace)
{
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const SpanPlace &place = trace.placeOf(span);
        if (place.axis == SpanAxis::Column && place.coordinate == x)
            return trace.indexOfSpan(span) + 1;
    }
    return trace.stepCount();
}

} // namespace

std::size_t positionOf(const OpeningPlace &place, const ScanTrace &trace)
{
    if (const auto *position = std::get_if<std::size_t>(&place))
        return std::min(*position, trace.stepCount());
    if (const auto *column = std::get_if<OpeningColumn>(&place))
        return justEntered(column->x, trace);
    return std::get<OpeningMoment>(place) == OpeningMoment::HalfDrawn ? halfDrawn(trace)
                                                                      : trace.stepCount();
}

} // namespace pixelplumb
