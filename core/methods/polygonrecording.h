// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/polygoncolumns.h"
#include "core/scan/polygonscan.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

/// How the numbers of a polygon's rows become records. A row of a whole polygon has any even number
/// of crossings, of which the first few are cells; a row of a triangle has two, its bounds.
template <class A, PolygonForm Form>
struct PolygonRecording : PolygonNumbers<A> {
    using typename PolygonNumbers<A>::SetUp;
    using typename PolygonNumbers<A>::Span;
    using typename PolygonNumbers<A>::Sample;

    static SpanPlace placeOf(const Span &row) { return {SpanAxis::Row, row.y, row.piece}; }
    static bool isClamped(const Sample &) { return false; }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        for (const std::size_t count : {setUp.contourCount, setUp.edgeCount, setUp.horizontalEdges})
            record.cells.push_back(Quantity::integer(Int128(count)));
        if constexpr (Form == PolygonForm::Triangles)
            record.cells.push_back(Quantity::integer(Int128(setUp.pieceCount)));
        record.cells.push_back(Quantity::integer(setUp.firstRow));
        record.cells.push_back(Quantity::integer(setUp.endRow - 1));
    }
    static void record(const Span &row, SpanRecord &record)
    {
        record.firstSample = row.firstSample;
        record.endSample = row.endSample;
        record.firstDrawn = row.firstDrawn;
        record.endDrawn = row.endDrawn;
        record.cells = {Quantity::integer(Int128(record.primitive)), Quantity::integer(row.y)};
        if constexpr (Form == PolygonForm::Triangles) {
            record.lower = Quantity::of(row.crossings.front().x);
            record.upper = Quantity::of(row.crossings.back().x);
            record.cells.push_back(Quantity::integer(row.piece));
            record.cells.push_back(Quantity::integer(record.drawnSamples()));
        } else {
            record.cells.push_back(Quantity::integer(Int128(row.crossings.size())));
        }
        for (std::size_t i = 0; i < shownCrossings(Form); ++i) {
            if (i >= row.crossings.size()) {
                record.cells.resize(record.cells.size() + cellsPerCrossing);
                continue;
            }
            const Crossing<A> &crossing = row.crossings[i];
            record.cells.push_back(Quantity::of(crossing.x));
            record.cells.push_back(Quantity::integer(Int128(crossing.edge)));
            for (const auto &number : {crossing.base, crossing.rise, crossing.slope})
                record.cells.push_back(Quantity::of(number));
        }
    }
    static void record(const Sample &sample, SampleRecord &record)
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            record.level[channel] = sample.colour.channels[channel];
            record.colour[channel] = Quantity::integer(record.level[channel]);
        }
        if constexpr (Form == PolygonForm::Whole) {
            record.cells
                = {Quantity::integer(sample.crossings), Quantity::integer(sample.crossings % 2),
                   Quantity::integer(sample.winding)};
        }
    }

    /// Fills a frame of this one row once more with the same numbers.
    template <class Observer>
    static void walk(const SetUp &setUp, const Span &row, const ScanSettings &, Observer observer)
    {
        const std::int64_t width = row.endDrawn - row.firstDrawn;
        if (width <= 0)
            return;
        std::vector<QRgb> pixels(std::size_t(width), QRgb(0));
        const FrameView frame{
            pixels.data(),       std::ptrdiff_t(width), std::int32_t(row.firstDrawn),
            std::int32_t(row.y), std::int32_t(width),   1};
        fillRow(row, setUp, frame, observer);
    }
};

} // namespace pixelplumb
