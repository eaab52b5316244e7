// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/plannedmethod.h"
#include "core/methods/shading/shadedrecorder.h"
#include "core/shade/shadeddrawing.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// What any triangle of the plan does.
ShadedScope scopeOf(InterpolationForm form, const Primitives &primitives,
                    const ScanSettings &settings, const EffectPlan &plan)
{
    ShadedScope scope;
    scope.form = form;
    scope.rounding = settings.rounding;
    scope.antialiasing = plan.antialiasing;
    scope.greatestDepth = greatestDepthLevel(primitives.appearance.depthFormat);
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
    forEachChannel(all, [&](std::size_t channel) {
        scope.channels.push_back({channel, channelAt(channel)});
    });
    if (all.light)
        scope.appearance = std::make_shared<const Appearance>(primitives.appearance);
    scope.isFiltered
        = std::ranges::any_of(primitives.appearance.materials, [](const Material &material) {
              return material.texture && material.filter == TextureFilter::Bilinear;
          });
    return scope;
}

} // namespace

std::unique_ptr<ScanTrace> traceShaded(ShadedMethod method, const Run &run, FrameView frame,
                                       const TraceOptions &options)
{
    const Primitives &primitives = run.primitives;
    const ScanSettings &settings = run.settings;
    const EffectPlan &plan = *run.shading();
    const InterpolationForm form = formOf(method);
    const auto trace = [&]<class N, class A>() {
        using R = ShadedRecording<N, A>;
        TriangleEffects effects(plan);
        using Picture = ShadedPictureRecorder<N, A>;
        std::unique_ptr<Picture> picture;
        const auto draw = [&](std::size_t index, const ObserverOf<R> &recorder) {
            if (!picture)
                picture
                    = std::make_unique<Picture>(form, primitives, settings, frame, plan, recorder);
            picture->draw(index, effects.at(index));
        };
        return recordTrace<R>(
            primitives.size(), settings, options,
            [&](std::size_t index) { return primitives.isTriangle(index); }, draw,
            TablesOf<R>::of(scopeOf(form, primitives, settings, plan)));
    };
    return withShadingNumbers(method, settings, shadingWidthsFor(primitives, plan), trace);
}

} // namespace pixelplumb
