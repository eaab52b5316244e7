// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/interpolationrecording.h"
#include "core/methods/kernelmethod.h"

#include <algorithm>

namespace pixelplumb {

/// Those of one triangle; null where it has none.
inline const TriangleAttributes *attributesOf(const Primitives &primitives, std::size_t triangle)
{
    const auto found = std::ranges::lower_bound(primitives.attributes, triangle, {},
                                                &TriangleAttributes::triangle);
    const bool isThere = found != primitives.attributes.end() && found->triangle == triangle;
    return isThere ? &*found : nullptr;
}

struct AttributedTriangle {
    const Triangle &triangle;
    const TriangleAttributes *attributes = nullptr;
};

template <InterpolationForm Form>
struct InterpolationKernel : TriangleKernel,
                             InExactOrFloat<CommonFraction, CommonFraction, float, double> {
    template <class Number>
    using Recording = InterpolationRecording<Form, Number>;

    static AttributedTriangle geometryOf(const Primitives &primitives, std::size_t index)
    {
        return {primitives.triangles[index], attributesOf(primitives, index)};
    }
    template <class Number, class Observer>
    static void scan(const AttributedTriangle &scanned, const ScanSettings &settings,
                     FrameView frame, Observer observer)
    {
        // The picture shows the colour: of the other channels it needs none.
        constexpr std::size_t channels = readsNumbers<Observer> ? channelCount : colourChannelCount;
        const auto scanIn = [&]<class Integer>() {
            InterpolationScan<Form, Number, Integer, channels, Observer>(
                scanned.triangle, scanned.attributes, settings, frame, observer)
                .run();
        };
        // What is covered is the same in both; who reads the numbers has one type of them.
        if constexpr (!readsNumbers<Observer>) {
            if (integerWidthFor(scanned.triangle) == IntegerWidth::Bits64) {
                scanIn.template operator()<NarrowBeside<Number>>();
                return;
            }
        }
        scanIn.template operator()<WideBeside<Number>>();
    }
};

} // namespace pixelplumb
