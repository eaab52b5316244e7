// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"
#include "core/methods/shading/interpolationrecording.h"

#include <algorithm>
#include <type_traits>

namespace pixelplumb {

/// Whether the exact fractions of a triangle's colours fit 64 bits: within 2^15 px and no wider or
/// higher than 4096 px. Then products with coordinates stay below 2^61, numerators at samples below
/// 2^57, and the bilinear form's products along two edges below 2^123.
constexpr bool hasNarrowFractions(const Triangle &triangle)
{
    constexpr Lattice longest = 4096 * unitsPerPixel;
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    return integerWidthFor(triangle) == IntegerWidth::Bits64 && right - left <= longest
        && high - low <= longest;
}

template <InterpolationForm Form>
struct InterpolationKernel : TriangleKernel,
                             InExactOrFloat<CommonFraction, CommonFraction, float, double> {
    template <class Number>
    using Recording = InterpolationRecording<Form, Number>;

    /// The picture shows only the colour, so no other channel is carried.
    template <class Number, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        const auto listener = listenerFor<Form>(observer);
        const auto scanIn = [&]<class InNumber, class Integer>() {
            using Listener = std::remove_const_t<decltype(listener)>;
            const auto scan = [&](const Triangle &scanned) {
                InterpolationScan<Form, InNumber, Integer, colourChannelCount, Listener>(
                    scanned, nullptr, CarriedChannels{}, settings, frame, listener)
                    .run();
            };
            if constexpr (axisOf(Form) == SpanAxis::Row)
                scan(FormTriangle<Form>(triangle, nullptr).triangle);
            else
                scan(triangle);
        };
        // The picture is the same in all number types; observers that read numbers get only one.
        if constexpr (!readsNumbers<Observer>) {
            if constexpr (std::is_same_v<Number, CommonFraction>) {
                if (hasNarrowFractions(triangle)) {
                    inOneFunction([&] {
                        scanIn.template operator()<FractionOf<std::int64_t>, std::int64_t>();
                    });
                    return;
                }
            }
            if (integerWidthFor(triangle) == IntegerWidth::Bits64) {
                scanIn.template operator()<Number, NarrowBeside<Number>>();
                return;
            }
        }
        scanIn.template operator()<Number, WideBeside<Number>>();
    }
};

} // namespace pixelplumb
