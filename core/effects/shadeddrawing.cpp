// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/shadeddrawing.h"

#include "core/effects/countedshading.h"
#include "core/effects/shadedpicture.h"

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

void drawShaded(ShadedMethod method, const Primitives &primitives, const ScanSettings &settings,
                FrameView frame, const EffectPlan &plan)
{
    drawShaded(method, primitives, settings, frame, plan, {});
}

bool drawShaded(ShadedMethod method, const Primitives &primitives, const ScanSettings &settings,
                FrameView frame, const EffectPlan &plan, const ProgressListener &listener)
{
    const ShadingWidths widths = shadingWidthsFor(primitives, plan);
    return withShadedMethod(method, [&]<ShadedMethod known>() {
        return withShadingNumbers<known>(
            settings, widths, [&]<InterpolationForm Form, class N, class A>() {
                if constexpr (isRaced<N, A>())
                    return ShadedPicture<Form, N, A, NullObserver>(primitives, settings, frame,
                                                                   plan, NullObserver{}, listener)
                        .draw();
                else
                    return drawCounted(method, primitives, settings, frame, plan, listener)
                        .has_value();
            });
    });
}

EffectTally countShaded(ShadedMethod method, const Primitives &primitives,
                        const ScanSettings &settings, FrameView frame, const EffectPlan &plan)
{
    return drawCounted(method, primitives, settings, frame, plan, {}).value();
}

} // namespace pixelplumb
