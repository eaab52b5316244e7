// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/interpolationrecording.h"
#include "core/methods/kernelmethod.h"

#include <algorithm>

namespace pixelplumb {

inline std::array<VertexAttributes, 3> attributesOf(const Primitives &primitives,
                                                    std::size_t triangle)
{
    const auto found = std::ranges::lower_bound(primitives.attributes, triangle, {},
                                                &TriangleAttributes::triangle);
    if (found == primitives.attributes.end() || found->triangle != triangle)
        return {};
    return found->vertices;
}

struct AttributedTriangle {
    const Triangle &triangle;
    std::array<VertexAttributes, 3> attributes;
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
        InterpolationScan<Form, Number, Observer>(scanned.triangle, scanned.attributes, settings,
                                                  frame, observer)
            .run();
    }
};

} // namespace pixelplumb
