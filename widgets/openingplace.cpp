// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/openingplace.h"

namespace pixelplumb {

namespace {

std::size_t halfDrawn(const ScanTrace &trace)
{
    for (std::size_t column = 0; column < trace.columnCount(); ++column) {
        const std::size_t pixels = trace.endPixelOf(column) - trace.firstPixelOf(column);
        if (trace.halfOf(column) == ColumnHalf::Second && pixels > 0)
            return trace.indexOfColumn(column) + 1 + pixels / 3;
    }
    return trace.stepCount();
}

std::size_t justEntered(std::int64_t x, const ScanTrace &trace)
{
    for (std::size_t column = 0; column < trace.columnCount(); ++column) {
        if (trace.xOf(column) == x)
            return trace.indexOfColumn(column) + 1;
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
