// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/edgetest.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

/// How the numbers of an edge test become records; the cells stand in the order of
/// edgeTestSetUpColumns() and its fellows.
template <class A, EdgeTestForm form>
struct EdgeTestRecording : EdgeTestNumbers<A> {
    using typename EdgeTestNumbers<A>::SetUp;
    using typename EdgeTestNumbers<A>::Span;
    using typename EdgeTestNumbers<A>::Sample;
    using Number = typename A::Number;

    static constexpr bool isRow = form.order == LoopOrder::RowByRow;
    static constexpr bool isIncremental = form.evaluation == Evaluation::Increments;

    static SpanPlace placeOf(const Span &span)
    {
        return {isRow ? SpanAxis::Row : SpanAxis::Column, span.coordinate, 0};
    }
    static bool isClamped(const Sample &sample) { return sample.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.zeroArea = setUp.zeroArea;
        std::vector<Quantity> &cells = record.cells;
        for (const Vertex &vertex : setUp.vertices) {
            cells.push_back(length(vertex.position.x));
            cells.push_back(length(vertex.position.y));
        }
        if constexpr (form.inside == InsideTest::Cramer)
            appendCramer(cells, setUp);
        else
            appendLines(cells, setUp);
        for (const bool owns : setUp.ownsTie)
            cells.push_back(Quantity::integer(owns));
        if constexpr (form.isBarycentric() && isIncremental) {
            for (const auto *rates :
                 {&setUp.weightPerX, &setUp.weightPerY, &setUp.colourPerX, &setUp.colourPerY})
                append(cells, *rates);
        }
        for (const Vertex &vertex : setUp.vertices) {
            for (const std::uint8_t level : vertex.colour.channels)
                cells.push_back(Quantity::integer(level));
        }
    }

    static void record(const Span &span, SpanRecord &record)
    {
        record.firstSample = span.firstSample;
        record.endSample = span.endSample;
        record.firstDrawn = span.firstTested;
        record.endDrawn = span.endTested;
        record.cells
            = {Quantity::integer(Int128(record.primitive)), Quantity::integer(span.coordinate),
               Quantity::integer(span.firstTested), Quantity::integer(span.endTested - 1)};
        if constexpr (isIncremental && form.isBarycentric()) {
            append(record.cells, span.weight);
            append(record.cells, span.colour);
        } else if constexpr (isIncremental) {
            for (const Number &value : span.value)
                record.cells.push_back(A::quantityOf(value, squareUnitsPerPixel));
        }
    }

    static void record(const Sample &sample, SampleRecord &record)
    {
        constexpr bool alwaysColoured = isIncremental && form.isBarycentric();
        const bool isColoured = sample.covered || (alwaysColoured && !sample.ofSegment);
        if (isColoured) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                record.colour[channel] = A::quantityOf(sample.colour[channel]);
        }
        record.level = sample.level;
        std::vector<Quantity> &cells = record.cells;
        if (sample.ofSegment)
            return;
        if constexpr (form.inside != InsideTest::Cramer && !alwaysColoured) {
            for (std::size_t line = 0; line < 3; ++line)
                cells.push_back(A::quantityOf(sample.value[line], sample.unit[line]));
        }
        if constexpr (form.isBarycentric())
            append(cells, sample.weight);
        cells.insert(cells.end(), record.colour.begin(), record.colour.end());
    }

    /// Tests the samples of a frame of this one span once more with the same numbers.
    template <class Observer>
    static void walk(const SetUp &setUp, const Span &span, const ScanSettings &settings,
                     Observer observer)
    {
        const auto length = std::int32_t(span.endTested - span.firstTested);
        std::vector<QRgb> pixels(std::size_t(length), QRgb(0));
        const auto across = std::int32_t(span.coordinate);
        const auto first = std::int32_t(span.firstTested);
        const FrameView frame = isRow ? FrameView{pixels.data(), length, first, across, length, 1}
                                      : FrameView{pixels.data(), 1, across, first, 1, length};
        testSpan<A, form>(setUp, span, settings.rounding, frame, observer);
    }

private:
    static Quantity length(Lattice units) { return A::quantityOf(A::length(units), unitsPerPixel); }
    static void append(std::vector<Quantity> &cells, const std::array<typename A::Ratio, 3> &ratios)
    {
        for (const auto &ratio : ratios)
            cells.push_back(A::quantityOf(ratio));
    }

    static void appendLines(std::vector<Quantity> &cells, const SetUp &setUp)
    {
        for (std::size_t line = 0; line < 3; ++line) {
            const EdgeLine<A> &edge = setUp.lines[line];
            if constexpr (form.line == LineForm::Solved)
                cells.push_back(edge.determinant == Number(0)
                                    ? Quantity::integer(1)
                                    : A::quantityOf(edge.determinant, squareUnitsPerPixel));
            if constexpr (form.line == LineForm::CanonicalEnd) {
                cells.push_back(length(edge.origin.x));
                cells.push_back(length(edge.origin.y));
            }
            if constexpr (!form.isBarycentric())
                cells.push_back(Quantity::integer(edge.sign));
            cells.push_back(A::quantityOfRate(edge.a, edge.unit));
            cells.push_back(A::quantityOfRate(edge.b, edge.unit));
            if constexpr (form.line == LineForm::Absolute || form.line == LineForm::Solved)
                cells.push_back(A::quantityOf(edge.c, edge.unit));
            cells.push_back(A::quantityOf(setUp.atOpposite[line], edge.unit));
        }
    }

    /// A − C, B − C and their determinant, from the lines bc and ca that they span.
    static void appendCramer(std::vector<Quantity> &cells, const SetUp &setUp)
    {
        const Number zero(0);
        const EdgeLine<A> &bc = setUp.lines[0];
        const EdgeLine<A> &ca = setUp.lines[1];
        for (const Number &difference : {zero - ca.b, ca.a, bc.b, zero - bc.a})
            cells.push_back(A::quantityOf(difference, unitsPerPixel));
        cells.push_back(A::quantityOf(zero - setUp.atOpposite[0], squareUnitsPerPixel));
    }
};

} // namespace pixelplumb
