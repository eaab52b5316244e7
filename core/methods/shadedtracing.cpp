// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shadedtracing.h"

#include "core/effects/shadeddrawing.h"
#include "core/methods/shadedrecorder.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// What some triangle of the plan does.
ShadedScope scopeOf(InterpolationForm form, const Primitives &primitives,
                    const ScanSettings &settings, const EffectPlan &plan)
{
    ShadedScope scope;
    scope.form = form;
    scope.rounding = settings.rounding;
    scope.antialiasing = plan.antialiasing;
    EffectSet &all = scope.effects;
    for (const EffectBatch &batch : plan.batches) {
        all.smooth |= batch.effects.smooth;
        all.perspective |= batch.effects.perspective;
        all.texture |= batch.effects.texture;
        all.light |= batch.effects.light;
        all.blending |= batch.effects.blending;
        all.depth = std::max(all.depth, batch.effects.depth);
    }
    all.blending |= plan.antialiasing == Antialiasing::Area;
    if (all.light)
        scope.appearance = std::make_shared<const Appearance>(primitives.appearance);
    scope.isFiltered
        = std::ranges::any_of(primitives.appearance.materials, [](const Material &material) {
              return material.texture && material.filter == TextureFilter::Bilinear;
          });
    return scope;
}

template <ShadedMethod method>
std::unique_ptr<ScanTrace> traceBy(const Primitives &primitives, const ScanSettings &settings,
                                   FrameView frame, const EffectPlan &plan,
                                   const TraceOptions &options)
{
    const auto trace = [&]<InterpolationForm Form, class N, class A>() {
        using R = ShadedRecording<Form, N, A>;
        TriangleEffects effects(plan);
        std::unique_ptr<ShadedSurroundings<N>> surroundings;
        std::unique_ptr<SampledRecording<Form, N, A, TraceRecorder<R>>> sampled;
        const auto draw = [&](std::size_t index, const TraceRecorder<R> &recorder) {
            const EffectSet &set = effects.at(index);
            if (!samplePattern(plan.antialiasing).empty()) {
                if (!sampled)
                    sampled = std::make_unique<SampledRecording<Form, N, A, TraceRecorder<R>>>(
                        primitives, settings, frame, plan, recorder);
                sampled->draw(index, set);
                return;
            }
            if (!surroundings)
                surroundings
                    = std::make_unique<ShadedSurroundings<N>>(plan, primitives.appearance, frame);
            ShadedRun<Form, N, A, TraceRecorder<R>> run(primitives, settings, recorder);
            if (plan.antialiasing == Antialiasing::Area)
                run.drawAreas(index, set, frame, *surroundings);
            else
                run.draw(index, set, frame, *surroundings);
        };
        return recordTrace<R>(
            primitives.size(), settings, options,
            [&](std::size_t index) { return primitives.isTriangle(index); }, draw,
            TablesOf<R>::of(scopeOf(Form, primitives, settings, plan)));
    };
    return withShadingNumbers<method>(settings, shadingWidthsFor(primitives, plan), trace);
}

} // namespace

std::unique_ptr<ScanTrace> traceShaded(ShadedMethod method, const Primitives &primitives,
                                       const ScanSettings &settings, FrameView frame,
                                       const EffectPlan &plan, const TraceOptions &options)
{
    switch (method) {
    case ShadedMethod::Plane:
        return traceBy<ShadedMethod::Plane>(primitives, settings, frame, plan, options);
    case ShadedMethod::Barycentric:
        return traceBy<ShadedMethod::Barycentric>(primitives, settings, frame, plan, options);
    case ShadedMethod::Bilinear:
        return traceBy<ShadedMethod::Bilinear>(primitives, settings, frame, plan, options);
    case ShadedMethod::ColumnScan:
        break;
    }
    return traceBy<ShadedMethod::ColumnScan>(primitives, settings, frame, plan, options);
}

} // namespace pixelplumb
