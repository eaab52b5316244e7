// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/biasnumber.h"
#include "core/scan/edgewalk.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

/// How the numbers of an edge walk become records; the cells stand in the order of
/// edgeWalkSetUpColumns() and its fellows.
template <class A, SpanAxis axis, WalkForm form>
struct EdgeWalkRecording : EdgeWalkNumbers<A> {
    using typename EdgeWalkNumbers<A>::SetUp;
    using typename EdgeWalkNumbers<A>::Span;
    using typename EdgeWalkNumbers<A>::Sample;
    using Number = typename A::Number;

    static constexpr bool isRow = axis == SpanAxis::Row;

    static SpanPlace placeOf(const Span &span)
    {
        return {axis, across(span.column.x), int(span.column.half)};
    }
    static bool isClamped(const Sample &fragment) { return fragment.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.order = setUp.scan.order;
        record.longEdge = setUp.scan.longEdge;
        record.zeroArea = setUp.scan.zeroArea;
        std::vector<Quantity> &cells = record.cells;
        for (const Vertex &corner : setUp.corners) {
            cells.push_back(inPixels(corner.position.x));
            cells.push_back(inPixels(corner.position.y));
            for (const std::uint8_t level : corner.colour.channels)
                cells.push_back(Quantity::integer(level));
        }
        cells.push_back(
            Quantity::rational(doubledArea(setUp.corners[0].position, setUp.corners[1].position,
                                           setUp.corners[2].position),
                               Int128(unitsPerPixel) * unitsPerPixel));
        append(cells, setUp.scan.slope);
        for (const auto &rates : setUp.scan.colourRate)
            append(cells, rates);
        if constexpr (form == WalkForm::Direct) {
            for (const Number &slope : setUp.scan.slope)
                cells.push_back(Quantity::integer(!quantityOf(slope).isRational()));
        }
    }

    static void record(const Span &span, SpanRecord &record)
    {
        const ColumnState<A> &column = span.column;
        record.lower = quantityOf(column.yBottom);
        record.upper = quantityOf(column.yTop);
        record.firstSample = column.firstRow;
        record.endSample = column.endRow;
        record.firstDrawn = column.firstDrawnRow;
        record.endDrawn = column.endDrawnRow;
        std::vector<Quantity> &cells = record.cells;
        cells = {Quantity::integer(Int128(record.primitive)),
                 Quantity::integer(across(column.x)),
                 Quantity::integer(column.half == ColumnHalf::First ? 1 : 2),
                 record.lower,
                 record.upper,
                 Quantity::integer(column.firstRow),
                 Quantity::integer(column.endRow - 1),
                 Quantity::integer(record.drawnSamples()),
                 Quantity::integer(column.firstDrawnRow)};
        for (const WalkedEdge<A> *edge : {&span.lower, &span.upper}) {
            cells.push_back(quantityOf(edge->slope));
            cells.push_back(inPixels(across(edge->fromAcross)));
            cells.push_back(quantityOf(edge->fromAlong));
        }
        if constexpr (form == WalkForm::Direct) {
            cells.push_back(biasOf(column.yBottom));
            cells.push_back(biasOf(column.yTop));
        }
        append(cells, column.colourBottom);
        append(cells, column.colourTop);
        append(cells, span.lower.fromColour);
        append(cells, span.upper.fromColour);
        append(cells, span.lower.colourRate);
        append(cells, span.upper.colourRate);
        append(cells, column.colourRate);
        if (record.drawnSamples() > 0)
            append(cells, column.firstColour);
        else
            cells.resize(cells.size() + 3);
    }

    static void record(const Sample &fragment, SampleRecord &record)
    {
        for (std::size_t channel = 0; channel < 3; ++channel)
            record.colour[channel] = quantityOf(fragment.colour[channel]);
        record.level = fragment.level;
        record.cells.assign(record.colour.begin(), record.colour.end());
    }

    /// Fills a frame of this one span once more with the same numbers.
    template <class Observer>
    static void walk(const SetUp &, const Span &span, const ScanSettings &settings,
                     Observer observer)
    {
        const ColumnState<A> &column = span.column;
        const auto length = std::int32_t(column.endDrawnRow - column.firstDrawnRow);
        if (length <= 0)
            return;
        std::vector<QRgb> pixels(std::size_t(length), QRgb(0));
        const auto first = std::int32_t(column.firstDrawnRow);
        const auto place = std::int32_t(across(column.x));
        const Triangle none;
        const EdgeWalkListener<A, axis, Observer> listener(none, none, form, observer);
        if constexpr (isRow) {
            const FrameView row{pixels.data(), length, first, place, length, 1};
            fillColumn(column, settings.rounding, TurnedView(row), listener);
        } else {
            const FrameView rows{pixels.data(), 1, place, first, 1, length};
            fillColumn(column, settings.rounding, rows, listener);
        }
    }

private:
    static constexpr std::int64_t across(std::int64_t column) { return isRow ? -column : column; }
    static Quantity inPixels(Lattice units) { return Quantity::rational(units, unitsPerPixel); }
    static void append(std::vector<Quantity> &cells, const std::array<Number, 3> &numbers)
    {
        for (const Number &number : numbers)
            cells.push_back(quantityOf(number));
    }
};

} // namespace pixelplumb
