// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/scenefile.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether the method draws the scene's first primitive; an empty scene counts as triangles.
bool drawsFirst(const Method &method, const Scene &scene)
{
    if (scene.hasTriangles() || scene.isEmpty())
        return method.draws(PrimitiveKind::Triangle);
    return method.draws(scene.shapes.front());
}

/// Whether the method supports what the scene may need for its first primitive.
bool canEffects(const Method &method, const Scene &scene, Arithmetic arithmetic)
{
    if (!scene.hasTriangles())
        return scene.isEmpty()
            || method.objection(scene.shapes.front(), scene.appearance).isEmpty();
    const std::vector<Arithmetic> &shading = method.shadingArithmetics;
    return !mayCallForEffects(scene)
        || (method.drawEffects
            && (shading.empty() || std::ranges::find(shading, arithmetic) != shading.end()));
}

} // namespace

ScanSettings settledFor(const Method &method, ScanSettings settings, const OpenSettings &open)
{
    const ScanSettings byDefault;
    if (open.arithmetic)
        settings.arithmetic = method.supports(byDefault.arithmetic) ? byDefault.arithmetic
                                                                    : method.arithmetics.front();
    if (open.fillRule)
        settings.fillRule
            = method.supports(byDefault.fillRule) ? byDefault.fillRule : method.fillRules.front();
    return settings;
}

const Method &methodFor(const Scene &scene, const OpenSettings &open)
{
    // The first that does it all; else one that keeps the settings, else one with the effects, else
    // any that draws.
    const Method *keeping = nullptr;
    const Method *shading = nullptr;
    const Method *drawing = nullptr;
    for (const Method &method : methods()) {
        if (!drawsFirst(method, scene))
            continue;
        const ScanSettings settings = settledFor(method, scene.settings, open);
        const bool keeps = method.objection(settings).isEmpty();
        const bool shades = canEffects(method, scene, settings.arithmetic);
        if (keeps && shades)
            return method;
        if (keeps && !keeping)
            keeping = &method;
        if (shades && !shading)
            shading = &method;
        if (!drawing)
            drawing = &method;
    }
    for (const Method *method : {keeping, shading, drawing}) {
        if (method)
            return *method;
    }
    return methods().front();
}

} // namespace pixelplumb
