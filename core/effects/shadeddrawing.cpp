// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/shadeddrawing.h"

#include "core/effects/shadedpicture.h"

#include <optional>

namespace pixelplumb {

namespace {

/// Hears the work of effects and no numbers.
struct CountingObserver : NullObserver {
    EffectTally *tally;

    explicit CountingObserver(EffectTally &counted)
        : tally(&counted)
    {
    }
    void worked(EffectWork work) const { ++tally->done[std::size_t(work)]; }
};

/// Hears nothing, but is no NullObserver: it gets the kernel that takes its effects when it runs.
struct GeneralObserver : NullObserver { };

/// The bytes of its depth buffer; none where the listener ended it.
using Drawing = std::optional<std::size_t>;

template <ShadedMethod method, class Observer>
Drawing drawBy(const Primitives &primitives, const ScanSettings &settings, FrameView frame,
               const EffectPlan &plan, Observer observer, const ProgressListener &listener)
{
    return withShadingNumbers<method>(
        settings, shadingWidthsFor(primitives, plan),
        [&]<InterpolationForm Form, class N, class A>() {
            ShadedPicture<Form, N, A, Observer> picture(primitives, settings, frame, plan, observer,
                                                        listener);
            return picture.draw() ? Drawing(picture.depthBytes()) : std::nullopt;
        });
}

template <class Observer>
Drawing drawHeard(ShadedMethod method, const Primitives &primitives, const ScanSettings &settings,
                  FrameView frame, const EffectPlan &plan, Observer observer,
                  const ProgressListener &listener = {})
{
    switch (method) {
    case ShadedMethod::Plane:
        return drawBy<ShadedMethod::Plane>(primitives, settings, frame, plan, observer, listener);
    case ShadedMethod::Barycentric:
        return drawBy<ShadedMethod::Barycentric>(primitives, settings, frame, plan, observer,
                                                 listener);
    case ShadedMethod::Bilinear:
        return drawBy<ShadedMethod::Bilinear>(primitives, settings, frame, plan, observer,
                                              listener);
    case ShadedMethod::ColumnScan:
        break;
    }
    return drawBy<ShadedMethod::ColumnScan>(primitives, settings, frame, plan, observer, listener);
}

} // namespace

template <>
inline constexpr bool readsNumbers<CountingObserver> = false;
template <>
inline constexpr bool readsNumbers<GeneralObserver> = false;

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
    drawHeard(method, primitives, settings, frame, plan, NullObserver{});
}

bool drawShaded(ShadedMethod method, const Primitives &primitives, const ScanSettings &settings,
                FrameView frame, const EffectPlan &plan, const ProgressListener &listener)
{
    return drawHeard(method, primitives, settings, frame, plan, NullObserver{}, listener)
        .has_value();
}

void drawShadedGenerally(ShadedMethod method, const Primitives &primitives,
                         const ScanSettings &settings, FrameView frame, const EffectPlan &plan)
{
    drawHeard(method, primitives, settings, frame, plan, GeneralObserver{});
}

EffectTally countShaded(ShadedMethod method, const Primitives &primitives,
                        const ScanSettings &settings, FrameView frame, const EffectPlan &plan)
{
    EffectTally tally;
    tally.depthBytes
        = drawHeard(method, primitives, settings, frame, plan, CountingObserver(tally)).value();
    return tally;
}

} // namespace pixelplumb
