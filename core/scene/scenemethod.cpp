// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scan/choicenames.h"
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

/// The scene's appearance, but what is forced off counts as called for, so that switching an effect
/// off changes no method.
Appearance withNothingOff(Appearance appearance)
{
    for (const Effect effect : allEffects) {
        if (appearance.forced[effect] == Forcing::Off)
            appearance.forced[effect] = Forcing::AsCalledFor;
    }
    return appearance;
}

bool hasSmoothTriangle(const Scene &scene)
{
    return std::ranges::any_of(scene.triangles, [](const Triangle &triangle) {
        const auto &[a, b, c] = triangle.vertices;
        return a.colour != b.colour || b.colour != c.colour;
    });
}

/// Whether a plan of the scene's triangles may run more than the method does plainly.
bool mayRunMore(const Method &method, const Scene &scene)
{
    const bool mayCallForMore
        = !scene.attributes.empty() || scene.hasSolids() || scene.appearance.namesEffects();
    const EffectForcing &forced = scene.appearance.forced;
    // Texture and light run only where triangles carry something for them.
    constexpr std::array forceable
        = {Effect::Depth, Effect::Perspective, Effect::Blending, Effect::Antialiasing};
    const auto isForcedOn = [&forced](Effect effect) { return forced[effect] == Forcing::On; };
    // Only methods that shade by a plan can leave colours out.
    return mayCallForMore
        || (forced[Effect::SmoothColour] == Forcing::Off && hasSmoothTriangle(scene))
        || std::ranges::any_of(forceable, isForcedOn)
        || (isForcedOn(Effect::SmoothColour) && !method.supports(Effect::SmoothColour));
}

/// Whether the method supports what the scene may need for its first primitive.
bool canEffects(const Method &method, const Scene &scene, const ScanSettings &settings)
{
    if (!scene.hasTriangles())
        return scene.isEmpty()
            || method.objection(scene.shapes.front(), withNothingOff(scene.appearance), settings)
                   .isEmpty();
    return !mayRunMore(method, scene)
        || (method.supports(Effect::Blending) && method.shadesIn(settings.arithmetic));
}

/// Whether any method that draws the scene's first primitive keeps the settings, but for open ones.
bool isKeptByAny(const Scene &scene, const ScanSettings &settings, const OpenSettings &open)
{
    return std::ranges::any_of(methods(), [&](const Method &method) {
        return drawsFirst(method, scene)
            && method.objection(settledFor(method, settings, open)).isEmpty();
    });
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
        const bool shades = canEffects(method, scene, settings);
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

QString refusalOfAll(const Scene &scene, const OpenSettings &open)
{
    const ScanSettings &settings = scene.settings;
    QStringList named;
    QStringList ways;
    const auto ask = [&](const QString &setting, std::string_view name, const ScanSettings &without,
                         const OpenSettings &opened) {
        named += QStringLiteral("%1 “%2”").arg(setting, nameText(name));
        if (isKeptByAny(scene, without, opened))
            ways += QStringLiteral("without ") + setting;
    };
    if (!open.fillRule)
        ask(QStringLiteral("the fill rule"), nameOf(settings.fillRule), settings,
            {open.method, open.arithmetic, true});
    if (!open.arithmetic)
        ask(QStringLiteral("the arithmetic"), nameOf(settings.arithmetic), settings,
            {open.method, true, open.fillRule});
    for (const Variant variant : variantsIn(settings.variants)) {
        ScanSettings without = settings;
        without.variants = without.variants.without(variant);
        ask(QStringLiteral("the variant"), nameOf(variant), without, open);
    }
    const QString text = QStringLiteral("no method that draws its first primitive keeps ")
        + named.join(QStringLiteral(" and "));
    return ways.isEmpty()
        ? text
        : text + QStringLiteral("; one does ") + ways.join(QStringLiteral(", or "));
}

} // namespace pixelplumb
