// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/effectplan.h"

#include <algorithm>

namespace pixelplumb {

std::optional<EffectPlan> planBeyondColour(const Primitives &primitives,
                                           const ScanSettings &settings, const FrameView &frame)
{
    const Appearance &appearance = primitives.appearance;
    // Most scenes carry nothing and need no plan.
    const bool mayCallForMore = !primitives.attributes.empty() || appearance.asksForEffects();
    if (!mayCallForMore || primitives.triangles.empty())
        return std::nullopt;
    EffectPlan plan = planFor(primitives, settings, frame);
    // The plain kernels interpolate whatever colours there are.
    const bool losesColours = appearance.forced[Effect::SmoothColour] == Forcing::Off
        && plan.verdicts[Effect::SmoothColour].verdict == Verdict::CalledFor;
    if (plan.isPlain() && !losesColours)
        return std::nullopt;
    return plan;
}

} // namespace pixelplumb
