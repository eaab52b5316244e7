// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/countedshading.h"

#include "core/effects/shadedpicture.h"
#include "core/scan/kernelnumbers.h"

#include <type_traits>

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

template <ShadedMethod method>
std::optional<EffectTally> drawBy(const Primitives &primitives, const ScanSettings &settings,
                                  FrameView frame, const EffectPlan &plan,
                                  const ProgressListener &listener)
{
    const auto draw
        = [&]<InterpolationForm Form, class N, class A>() -> std::optional<EffectTally> {
        // Bounds are exact in either width: nothing here is timed.
        using Bounds = std::conditional_t<N::isExact, A, WidestOf<A>>;
        EffectTally tally;
        ShadedPicture<Form, N, Bounds, CountingObserver> picture(primitives, settings, frame, plan,
                                                                 CountingObserver(tally), listener);
        if (!picture.draw())
            return std::nullopt;
        tally.depthBytes = picture.depthBytes();
        return tally;
    };
    return withShadingNumbers<method>(settings, shadingWidthsFor(primitives, plan), draw);
}

} // namespace

template <>
inline constexpr bool readsNumbers<CountingObserver> = false;

std::optional<EffectTally> drawCounted(ShadedMethod method, const Primitives &primitives,
                                       const ScanSettings &settings, FrameView frame,
                                       const EffectPlan &plan, const ProgressListener &listener)
{
    return withShadedMethod(method, [&]<ShadedMethod known>() {
        return drawBy<known>(primitives, settings, frame, plan, listener);
    });
}

} // namespace pixelplumb
