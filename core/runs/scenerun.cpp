// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/scenerun.h"

#include "core/methods/objectiontext.h"
#include "core/plan/bordercrossing.h"
#include "core/plan/requirements.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const Method *methodOf(const Scene &scene)
{
    return methodNamed(QString::fromStdString(scene.method));
}

/// Whether what the scene calls for cannot matter: nothing may be, or the method supports
/// everything for its triangles, once an objection of its own is met.
bool isDrawnWhateverItCallsFor(const Method &method, const Scene &scene)
{
    if (!mayCallForEffects(scene))
        return true;
    const ScanSettings kept = method.adapted(scene.settings);
    return method.draws(PrimitiveKind::Triangle) && scene.hasTriangles() && kept.isRight()
        && std::ranges::all_of(allEffects,
                               [&method](Effect effect) { return method.supports(effect); })
        && method.shadesIn(kept.arithmetic);
}

/// The objection to those shapes that reach the frame.
QString objectionToShapes(const SceneRun &run)
{
    const Scene &scene = run.scene;
    const SampledFrame where
        = {windowOf(scene.frame), scene.settings.fillRule, antialiasingOf(scene.appearance)};
    for (const Shape &shape : run.primitives.shapes) {
        if (borderCrossingOf(shape, where) == BorderCrossing::Outside)
            continue;
        QString objection = run.method->objection(shape, scene.appearance, scene.settings);
        if (!objection.isEmpty())
            return objection;
    }
    return {};
}

/// What stays in the way of a scene of triangles once the method's own objection is met, by any of
/// the rules that it names, since another fill rule may call for more. Methods named for that keep
/// the settings.
QString objectionOnceAdapted(const SceneRun &run)
{
    const Method &method = *run.method;
    const ScanSettings &settings = run.scene.settings;
    Scene met = run.scene;
    met.settings = method.adapted(settings);
    const std::vector<FillRule> rules
        = method.supports(settings.fillRule) ? std::vector{settings.fillRule} : method.fillRules;
    for (const FillRule rule : rules) {
        met.settings.fillRule = rule;
        const std::optional<EffectPlan> plan = SceneRun(met).plan;
        if (plan && !method.objection(*plan, met.settings).isEmpty())
            return method.objection(*plan, settings);
    }
    return {};
}

} // namespace

SceneRun::SceneRun(const Scene &of, Primitives onSamples)
    : Run(methodOf(of), std::move(onSamples), of.settings, windowOf(of.frame))
    , scene(of)
{
}

SceneRun::SceneRun(const Scene &of)
    : SceneRun(of, primitivesOnSamples(of))
{
}

std::optional<SceneRun> sceneRunOf(const Scene &scene, const ProgressListener &listener)
{
    auto primitives = primitivesOnSamples(scene, listener);
    return primitives ? std::optional<SceneRun>(std::in_place, scene, std::move(*primitives))
                      : std::nullopt;
}

EffectPlan planOf(const SceneRun &run) { return planOf(run, windowOf(run.scene.frame)); }

QString objectionTo(const SceneRun &run)
{
    const Scene &scene = run.scene;
    const Method &method = *run.method;
    const QString objection = method.objection(scene.settings);
    if (isDrawnWhateverItCallsFor(method, scene))
        return objection;
    if (!method.draws(PrimitiveKind::Triangle) || !scene.hasTriangles())
        return joinedObjections({objection, objectionToShapes(run)});
    if (objection.isEmpty())
        return run.plan ? method.objection(*run.plan, scene.settings) : objection;
    return joinedObjections({objection, objectionOnceAdapted(run)});
}

QString objectionTo(const Scene &scene)
{
    const Method &method = *methodOf(scene);
    return isDrawnWhateverItCallsFor(method, scene) ? method.objection(scene.settings)
                                                    : objectionTo(SceneRun(scene));
}

bool drawsAnyOf(const Scene &scene)
{
    const Method &method = *methodOf(scene);
    return scene.isEmpty() || (scene.hasTriangles() && method.draws(PrimitiveKind::Triangle))
        || std::ranges::any_of(scene.shapes,
                               [&method](const Shape &shape) { return method.draws(shape); });
}

} // namespace pixelplumb
