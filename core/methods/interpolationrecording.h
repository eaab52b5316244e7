// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/interpolationscan.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

/// How the numbers of an interpolation become records.
template <InterpolationForm Form, class Number>
struct InterpolationRecording : InterpolationNumbers<Number> {
    using typename InterpolationNumbers<Number>::SetUp;
    using typename InterpolationNumbers<Number>::Span;
    using typename InterpolationNumbers<Number>::Sample;

    static SpanPlace placeOf(const Span &column)
    {
        return {SpanAxis::Column, column.x, int(column.half)};
    }
    static bool isClamped(const Sample &sample) { return sample.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.order = setUp.order;
        record.longEdge = setUp.longEdge;
        record.zeroArea = setUp.zeroArea;
        // Without an area there is no plane and there are no weights.
        if constexpr (Form == InterpolationForm::Plane) {
            for (const auto &coefficients : setUp.plane)
                append(record.cells, coefficients, setUp.zeroArea);
        } else if constexpr (Form == InterpolationForm::Barycentric) {
            for (const auto &coefficients : setUp.weight)
                append(record.cells, coefficients, setUp.zeroArea);
            for (std::size_t channel = 0; channel < channelCount; ++channel) {
                for (const ChannelVertex &vertex : setUp.vertices)
                    record.cells.push_back(
                        Quantity::rational(vertex.channels[channel], unitsPerPixel));
            }
        }
    }
    static void record(const Span &column, SpanRecord &record)
    {
        record.lower = Quantity::of(column.lower);
        record.upper = Quantity::of(column.upper);
        record.firstSample = column.firstRow;
        record.endSample = column.endRow;
        record.firstDrawn = column.firstDrawn;
        record.endDrawn = column.endDrawn;
        record.cells = {Quantity::integer(Int128(record.primitive)),
                        Quantity::integer(column.x),
                        Quantity::integer(column.half == ColumnHalf::First ? 1 : 2),
                        Quantity::integer(column.firstRow),
                        Quantity::integer(column.endRow - 1),
                        Quantity::integer(record.drawnSamples())};
        if constexpr (Form == InterpolationForm::Bilinear) {
            record.cells.push_back(quantityOf(column.yBottom));
            record.cells.push_back(quantityOf(column.yTop));
            for (const auto *numbers : {&column.bottom, &column.top, &column.rate})
                append(record.cells, *numbers, false);
        }
    }
    static void record(const Sample &sample, SampleRecord &record)
    {
        if constexpr (Form == InterpolationForm::Barycentric)
            append(record.cells, sample.weight, false);
        append(record.cells, sample.value, false);
        for (std::size_t i = 0; i < 3; ++i)
            record.colour[i] = quantityOf(sample.value[i]);
        record.level = sample.level;
    }

    /// Fills a frame of this one column once more with the same numbers.
    template <class Observer>
    static void walk(const SetUp &setUp, const Span &column, const ScanSettings &settings,
                     Observer observer)
    {
        const std::int64_t height = column.endDrawn - column.firstDrawn;
        if (height <= 0)
            return;
        std::vector<QRgb> pixels(std::size_t(height), QRgb(0));
        const FrameView frame{
            pixels.data(),       1, std::int32_t(column.x), std::int32_t(column.firstDrawn), 1,
            std::int32_t(height)};
        fillInterpolated<Form>(setUp, column, settings.rounding, frame, observer);
    }

private:
    static Quantity quantityOf(const Ratio &ratio)
    {
        return Quantity::rational(ratio.numerator, ratio.denominator);
    }
    template <std::floating_point Float>
    static Quantity quantityOf(Float value)
    {
        return Quantity::of(value);
    }

    template <std::size_t Count>
    static void append(std::vector<Quantity> &cells, const std::array<Number, Count> &numbers,
                       bool areNone)
    {
        for (const Number &number : numbers)
            cells.push_back(areNone ? Quantity() : quantityOf(number));
    }
};

} // namespace pixelplumb
