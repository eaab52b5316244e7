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

/// A setting that the scene names.
struct NamedSetting {
    QString kind; ///< "the fill rule"
    std::string_view name;
    std::optional<Variant> variant = {};
    bool OpenSettings::*open = nullptr; ///< of a setting that is no variant

    void drop(ScanSettings &settings, OpenSettings &others) const
    {
        if (variant)
            settings.variants = settings.variants.without(*variant);
        else
            others.*open = true;
    }
};

std::vector<NamedSetting> namedSettings(const ScanSettings &settings, const OpenSettings &open)
{
    std::vector<NamedSetting> named;
    if (!open.fillRule)
        named.push_back(
            {"the fill rule", nameOf(settings.fillRule), std::nullopt, &OpenSettings::fillRule});
    if (!open.arithmetic)
        named.push_back({"the arithmetic", nameOf(settings.arithmetic), std::nullopt,
                         &OpenSettings::arithmetic});
    for (const Variant variant : variantsIn(settings.variants))
        named.push_back({"the variant", nameOf(variant), variant});
    return named;
}

/// Whether the method that is chosen draws the scene, effects included, once these settings are no
/// longer named.
bool isDrawnWithout(const std::vector<NamedSetting> &dropped, Scene scene, OpenSettings open)
{
    for (const NamedSetting &setting : dropped)
        setting.drop(scene.settings, open);
    const Method &method = methodFor(scene, open);
    const ScanSettings settings = settledFor(method, scene.settings, open);
    if (!drawsFirst(method, scene) || !method.objection(settings).isEmpty())
        return false;
    if (!scene.hasTriangles())
        return scene.isEmpty()
            || method.objection(scene.shapes.front(), scene.appearance, settings).isEmpty();
    const Run run(&method, primitivesOnSamples(scene), settings, windowOf(scene.frame));
    return !run.plan || method.objection(*run.plan, settings).isEmpty();
}

/// Each smallest set of named settings without which some method draws the scene; pairs are tried
/// where no single one is in the way, and all of them where no pair is.
std::vector<std::vector<NamedSetting>> waysOut(const std::vector<NamedSetting> &named,
                                               const Scene &scene, const OpenSettings &open)
{
    std::vector<std::vector<NamedSetting>> ways;
    const auto tryWithout = [&](const std::vector<NamedSetting> &dropped) {
        if (isDrawnWithout(dropped, scene, open))
            ways.push_back(dropped);
    };
    for (const NamedSetting &setting : named)
        tryWithout({setting});
    for (std::size_t i = 0; ways.empty() && i < named.size(); ++i) {
        for (std::size_t k = i + 1; k < named.size(); ++k)
            tryWithout({named[i], named[k]});
    }
    if (ways.empty())
        tryWithout(named);
    return ways;
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
    const std::vector<NamedSetting> named = namedSettings(scene.settings, open);
    const auto textOf = [](const NamedSetting &setting) {
        return u"%1 “%2”"_s.arg(setting.kind, nameText(setting.name));
    };
    const bool hasSeveralVariants = variantsIn(scene.settings.variants).size() > 1;
    QStringList texts;
    for (const NamedSetting &setting : named)
        texts += textOf(setting);
    QStringList ways;
    for (const std::vector<NamedSetting> &way : waysOut(named, scene, open)) {
        QStringList dropped;
        for (const NamedSetting &setting : way)
            dropped += setting.variant && hasSeveralVariants ? textOf(setting) : setting.kind;
        ways += u"without "_s + dropped.join(u" and "_s);
    }
    const QString text
        = u"no method that draws its first primitive keeps "_s + texts.join(u" and "_s);
    return ways.isEmpty() ? text : text + u"; one does "_s + ways.join(u", or "_s);
}

} // namespace pixelplumb
