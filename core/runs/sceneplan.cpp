// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/sceneplan.h"

#include "core/effects/bordercrossing.h"
#include "core/effects/requirements.h"
#include "core/methods/method.h"
#include "core/methods/objectiontext.h"
#include "core/runs/contender.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether the method supports everything: then it does not matter what the scene calls for.
bool canAll(const Method &method, const ScanSettings &settings)
{
    return settings.variants.isEmpty()
        && std::ranges::all_of(allEffects,
                               [&method](Effect effect) { return method.supports(effect); })
        && method.shadesIn(settings.arithmetic);
}

/// The objection to those shapes that reach the frame.
QString objectionToShapes(const Method &method, const Scene &scene)
{
    const SampledFrame where
        = {windowOf(scene.frame), scene.settings.fillRule, antialiasingOf(scene.appearance)};
    for (const Shape &shape : primitivesOnSamples(scene).shapes) {
        if (borderCrossingOf(shape, where) == BorderCrossing::Outside)
            continue;
        QString objection = method.objection(shape, scene.appearance, scene.settings);
        if (!objection.isEmpty())
            return objection;
    }
    return {};
}

} // namespace

EffectPlan planOf(const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    const Primitives drawn = primitivesFor(primitivesOnSamples(scene), {&method, scene.settings});
    return planFor(drawn, scene.settings, windowOf(scene.frame));
}

QString objectionTo(const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    const QString objection = method.objection(scene.settings);
    if (!mayCallForEffects(scene))
        return objection;
    if (!method.draws(PrimitiveKind::Triangle) || !scene.hasTriangles())
        return joinedObjections({objection, objectionToShapes(method, scene)});
    const ScanSettings kept = method.adapted(scene.settings);
    if (canAll(method, kept))
        return objection;
    // What stays in the way once its own objection is met; methods named for that keep the
    // settings.
    const EffectPlan plan = planOf(scene);
    const QString ofEffects = method.objection(plan, kept);
    return joinedObjections(
        {objection, ofEffects.isEmpty() ? ofEffects : method.objection(plan, scene.settings)});
}

bool drawsAnyOf(const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    return scene.isEmpty() || (scene.hasTriangles() && method.draws(PrimitiveKind::Triangle))
        || std::ranges::any_of(scene.shapes,
                               [&method](const Shape &shape) { return method.draws(shape); });
}

} // namespace pixelplumb
