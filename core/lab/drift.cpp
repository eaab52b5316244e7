// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/bounderrors.h"
#include "core/lab/sizestudy.h"
#include "core/methods/method.h"
#include "core/number/failure.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

std::optional<std::vector<DriftCurve>> driftOver(std::int64_t columns,
                                                 const ProgressListener &listener)
{
    Scene scene;
    scene.frame.width = std::int32_t(std::clamp<std::int64_t>(columns + 1, 1, largestFrameSide));
    scene.frame.height = 1; // the bounds are what counts, not the pixels
    // As high as wide, with slopes that no binary number holds.
    scene.triangles = {{{{{latticePixel(0, 0), {{255, 0, 0}}},
                          {latticePixel(columns / 3, columns - 1), {{0, 255, 0}}},
                          {latticePixel(columns, 3 * columns / 7), {{0, 0, 255}}}}}}};
    std::optional<std::vector<BoundErrors>> errors;
    if (failureOf([&] { errors = boundErrorsOf(scene, 0, listener); }))
        return std::vector<DriftCurve>();
    if (!errors)
        return std::nullopt;
    std::vector<DriftCurve> curves;
    for (const BoundErrors &each : *errors) {
        DriftCurve curve{each.arithmetic, {}};
        for (const BoundError &span : each.spans) {
            curve.points.push_back({span.place.coordinate,
                                    std::max(std::abs(span.lower), std::abs(span.upper)),
                                    span.limit});
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace pixelplumb
