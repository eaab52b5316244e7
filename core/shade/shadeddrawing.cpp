// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/shadeddrawing.h"

#include "core/shade/shadedpicture.h"

namespace pixelplumb {

ShadingWidths shadingWidthsFor(const Primitives &primitives, const EffectPlan &plan)
{
    ShadingWidths widths;
    TriangleEffects effects(plan);
    for (std::size_t index = 0; index < primitives.triangles.size(); ++index) {
        const ShadedTriangle triangle{primitives.triangles[index], primitives.attributesOf(index)};
        EffectSet carried = effects.at(index);
        carried.blending = carried.blending || plan.antialiasing == Antialiasing::Area;
        if (integerWidthFor(triangle.triangle) != IntegerWidth::Bits64)
            widths.narrowBounds = false;
        if (!fitsNarrowShading(triangle, carried))
            widths.narrowShading = false;
        if (!widths.narrowBounds && !widths.narrowShading)
            break;
    }
    return widths;
}

std::optional<EffectTally> drawShaded(ShadedMethod method, const Primitives &primitives,
                                      const ScanSettings &settings, FrameView frame,
                                      const EffectPlan &plan, const ProgressListener &listener)
{
    const auto draw = [&]<class N, class A>() -> std::optional<EffectTally> {
        ShadedPicture<N, A> picture(formOf(method), primitives, settings, frame, plan, listener);
        if (!picture.draw())
            return std::nullopt;
        return picture.tally();
    };
    return withShadingNumbers(method, settings, shadingWidthsFor(primitives, plan), draw);
}

} // namespace pixelplumb
