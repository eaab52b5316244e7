// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/sceneplan.h"

#include "core/methods/method.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether the method can all that there is: then nobody needs to know what the scene calls for.
bool canAll(const Method &method, Arithmetic arithmetic)
{
    const std::vector<Arithmetic> &shading = method.shadingArithmetics;
    return std::ranges::all_of(allEffects,
                               [&method](Effect effect) { return method.supports(effect); })
        && (shading.empty() || std::ranges::find(shading, arithmetic) != shading.end());
}

} // namespace

bool mayCallForEffects(const Scene &scene)
{
    return !scene.attributes.empty() || !scene.solids.empty()
        || scene.appearance.antialiasing != Antialiasing::None
        || scene.appearance.forced != EffectForcing{};
}

EffectPlan planOf(const Scene &scene)
{
    return planFor(primitivesOnSamples(scene), scene.settings, windowOf(scene.frame));
}

QString objectionTo(const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    QString objection = method.objection(scene.settings);
    if (!objection.isEmpty() || !method.draws(PrimitiveKind::Triangle)
        || canAll(method, scene.settings.arithmetic) || !mayCallForEffects(scene))
        return objection;
    return method.objection(planOf(scene), scene.settings.arithmetic);
}

} // namespace pixelplumb
