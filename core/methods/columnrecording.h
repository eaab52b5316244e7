// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/columnrecord.h"
#include "core/scan/columnscan.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

/// How the column scan's numbers become records.
template <class A>
struct ColumnRecording : ColumnScanNumbers<A> {
    using typename ColumnScanNumbers<A>::SetUp;
    using typename ColumnScanNumbers<A>::Span;
    using typename ColumnScanNumbers<A>::Sample;

    static SpanPlace placeOf(const Span &column)
    {
        return {SpanAxis::Column, column.x, int(column.half)};
    }
    static bool isClamped(const Sample &fragment) { return fragment.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.order = setUp.order;
        record.longEdge = setUp.longEdge;
        record.zeroArea = setUp.zeroArea;
        append(record.cells, setUp.slope);
        for (const auto &rates : setUp.colourRate)
            append(record.cells, rates);
    }
    static void record(const Span &column, SpanRecord &record)
    {
        record.lower = Quantity::of(column.yBottom);
        record.upper = Quantity::of(column.yTop);
        record.firstSample = column.firstRow;
        record.endSample = column.endRow;
        record.firstDrawn = column.firstDrawnRow;
        record.endDrawn = column.endDrawnRow;
        record.cells.reserve(std::size_t(ColumnCell::Count));
        record.cells = {Quantity::integer(Int128(record.primitive)),
                        Quantity::integer(column.x),
                        Quantity::integer(column.half == ColumnHalf::First ? 1 : 2),
                        record.lower,
                        record.upper,
                        Quantity::integer(column.firstRow),
                        Quantity::integer(column.endRow - 1),
                        Quantity::integer(record.drawnSamples())};
        append(record.cells, column.colourBottom);
        append(record.cells, column.colourTop);
        append(record.cells, column.colourRate);
        if (record.drawnSamples() > 0)
            append(record.cells, column.firstColour);
        else
            record.cells.resize(std::size_t(ColumnCell::Count));
    }
    static void record(const Sample &fragment, SampleRecord &record)
    {
        for (std::size_t channel = 0; channel < 3; ++channel)
            record.colour[channel] = Quantity::of(fragment.colour[channel]);
        record.level = fragment.level;
    }

    /// Fills a frame of this one column once more with the same numbers.
    template <class Observer>
    static void walk(const SetUp &, const Span &column, const ScanSettings &settings,
                     Observer observer)
    {
        const std::int64_t height = column.endDrawnRow - column.firstDrawnRow;
        if (height <= 0)
            return;
        std::vector<QRgb> pixels(std::size_t(height), QRgb(0));
        const FrameView frame{
            pixels.data(),       1, std::int32_t(column.x), std::int32_t(column.firstDrawnRow), 1,
            std::int32_t(height)};
        fillColumn(column, settings.rounding, frame, observer);
    }

private:
    template <class Number>
    static void append(std::vector<Quantity> &cells, const std::array<Number, 3> &numbers)
    {
        for (const Number &number : numbers)
            cells.push_back(Quantity::of(number));
    }
};

} // namespace pixelplumb
