// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/methods/objectiontext.h"
#include "core/plan/requirements.h"
#include "core/scan/choicenames.h"
#include "core/shade/strokes/strokestrip.h"

#include <algorithm>

/// What a method cannot do, and which methods can.
namespace pixelplumb {

namespace {

QString quoted(std::string_view name) { return u'“' + nameText(name) + u'”'; }

/// What a plan runs that not every triangle method supports.
std::vector<Effect> shadingEffectsOf(const EffectPlan &plan)
{
    std::vector<Effect> effects;
    for (const Effect effect : allEffects) {
        if (effect != Effect::SmoothColour && effect != Effect::Clipping
            && plan.runsOnTriangles(effect))
            effects.push_back(effect);
    }
    return effects;
}

/// The ids of the methods.
template <class Draws>
QStringList methodsThatDo(const std::vector<Effect> &effects, const Draws &draws)
{
    QStringList ids;
    for (const Method &method : methods()) {
        const bool doesAll = std::ranges::all_of(
            effects, [&method](Effect effect) { return method.supports(effect); });
        if (doesAll && draws(method))
            ids.append(method.id);
    }
    return ids;
}

/// What asks for it: the scene, or only the user's switch.
QString askerText(bool isCalledFor)
{
    return isCalledFor ? u"which the scene calls for"_s : u"which is forced on"_s;
}
QString askerText(const EffectPlan &plan, const std::vector<Effect> &effects)
{
    const auto isCalledFor
        = [&plan](Effect effect) { return plan.verdicts[effect].verdict != Verdict::NotCalledFor; };
    const bool areAll = std::ranges::all_of(effects, isCalledFor);
    if (!areAll && std::ranges::any_of(effects, isCalledFor))
        return u"which the scene calls for or which are forced on"_s;
    return askerText(areAll);
}

/// "interpolate-plane can": which methods of the kind do the effects under the settings; where none
/// does, those that do with the fewest changes, and what is in their way.
template <class IsOfKind>
QString ableText(const std::vector<Effect> &effects, const ScanSettings &settings,
                 const IsOfKind &isOfKind)
{
    const auto computes = [&settings](const Method &method) {
        return method.supports(settings.arithmetic) && method.shadesIn(settings.arithmetic);
    };
    QStringList able;
    QStringList hindrances;
    const auto ask = [&](bool asksForRule, bool asksForArithmetic) {
        able = methodsThatDo(effects, [&](const Method &method) {
            return isOfKind(method) && (!asksForRule || method.supports(settings.fillRule))
                && (!asksForArithmetic || computes(method));
        });
        hindrances.clear();
        if (!asksForRule)
            hindrances += u"under the fill rule "_s + quoted(nameOf(settings.fillRule));
        if (!asksForArithmetic)
            hindrances += u"in "_s + quoted(nameOf(settings.arithmetic));
        return !able.isEmpty();
    };
    const bool isAny = ask(true, true) || ask(true, false) || ask(false, true) || ask(false, false);
    if (!isAny)
        return u"no method can"_s;
    // Effects are never run with variants.
    if (!settings.isRight())
        hindrances += u"with variants"_s;
    const QString text = u"%1 can"_s.arg(able.join(u", "_s));
    return hindrances.isEmpty() ? text : text + u", but not "_s + hindrances.join(u" and not "_s);
}

bool drawsTriangles(const Method &method) { return method.draws(PrimitiveKind::Triangle); }

/// `able`: which methods can.
QString lackText(const std::vector<Effect> &missing, const QString &asker, const QString &able)
{
    return u"cannot do %1, %2; %3"_s.arg(namesOf(missing).join(u", "_s), asker, able);
}

/// The ids of the methods that accept the variant: under the other settings, else under any.
QStringList methodsThatKnow(Variant variant, const ScanSettings &settings)
{
    QStringList knowing;
    QStringList keeping;
    for (const Method &method : methods()) {
        if (!method.supports(variant))
            continue;
        knowing.append(method.id);
        if (method.supports(settings.fillRule) && method.supports(settings.arithmetic))
            keeping.append(method.id);
    }
    return keeping.isEmpty() ? knowing : keeping;
}

QString unknownVariantText(const Method &method, Variant variant, const ScanSettings &settings)
{
    const QString separator = ", ";
    const QString text = u"knows no variant %1; that one is for %2"_s.arg(
        quoted(nameOf(variant)), methodsThatKnow(variant, settings).join(separator));
    return method.variants.empty()
        ? text
        : text + u"; its own variants are "_s + namesOf(method.variants).join(separator);
}

/// Most methods always draw colours: only those that shade by a plan can leave them out.
QString smoothColourObjection(const Method &method, const EffectPlan &plan,
                              const ScanSettings &settings)
{
    const bool isLeftOut = plan.verdicts[Effect::SmoothColour].verdict == Verdict::CalledFor
        && !plan.runs(Effect::SmoothColour);
    const bool shades = method.supports(Effect::Blending) && method.shadesIn(settings.arithmetic);
    if (!isLeftOut || (shades && settings.isRight()))
        return {};
    return u"cannot leave out smooth colour, which is forced off; %1"_s.arg(
        ableText({Effect::Blending}, settings, drawsTriangles));
}

} // namespace

QString Method::objection(const ScanSettings &settings) const
{
    QStringList objections;
    if (!supports(settings.arithmetic))
        objections += u"does not compute in %1; it knows %2"_s.arg(
            quoted(nameOf(settings.arithmetic)), namesOf(arithmetics).join(u", "_s));
    if (!supports(settings.fillRule))
        objections += u"cannot keep the fill rule %1: %2; it keeps %3"_s.arg(
            quoted(nameOf(settings.fillRule)), fillRuleReason, namesOf(fillRules).join(u", "_s));
    for (const Variant variant : variantsIn(settings.variants)) {
        if (!supports(variant))
            objections += unknownVariantText(*this, variant, settings);
    }
    if (!settings.bugs.isRight() && !walksEdges())
        objections += u"has none of the mistakes of a walk between two edges"_s;
    if (!settings.testBugs.isRight() && !testsEdges)
        objections += u"has none of the mistakes of a program that tests edges"_s;
    return joinedObjections(objections);
}

QString Method::objection(const EffectPlan &plan, const ScanSettings &settings) const
{
    if (!draws(PrimitiveKind::Triangle))
        return {};
    if (const QString text = smoothColourObjection(*this, plan, settings); !text.isEmpty())
        return text;
    if (plan.isPlain())
        return {};
    const std::vector<Effect> run = shadingEffectsOf(plan);
    std::vector<Effect> missing = run;
    std::erase_if(missing, [this](Effect effect) { return supports(effect); });
    if (!missing.empty())
        return lackText(missing, askerText(plan, missing),
                        ableText(missing, settings, drawsTriangles));
    QStringList hindrances;
    QStringList ways;
    if (!settings.isRight() && !run.empty()) {
        hindrances += u"with variants, which depart from its colours alone"_s;
        ways += u"without them"_s;
    }
    const QString separator = ", ";
    if (!shadesIn(settings.arithmetic)) {
        hindrances += u"in %1"_s.arg(quoted(nameOf(settings.arithmetic)));
        ways += u"in %1"_s.arg(namesOf(shadingArithmetics).join(separator));
    }
    if (hindrances.isEmpty())
        return {};
    return u"cannot do %1, %2, %3; it can %4"_s.arg(
        namesOf(run).join(separator), askerText(plan, run), hindrances.join(u", nor "_s),
        ways.join(u" and "_s));
}

QString Method::objection(const Shape &shape, const Appearance &appearance,
                          const ScanSettings &settings) const
{
    if (antialiasingOf(appearance) == Antialiasing::None || !isStroke(shape) || !draws(shape)
        || supports(Effect::Antialiasing))
        return {};
    return lackText({Effect::Antialiasing},
                    askerText(appearance.antialiasing != Antialiasing::None),
                    ableText({Effect::Antialiasing}, settings,
                             [&shape](const Method &method) { return method.draws(shape); }));
}

QString Method::refusal(const ScanSettings &settings) const
{
    const QString why = objection(settings);
    return why.isEmpty() ? why : u"method “%1” %2"_s.arg(id, why);
}

ScanSettings Method::adapted(const ScanSettings &settings) const
{
    ScanSettings drawn = settings;
    if (!supports(drawn.arithmetic) && !arithmetics.empty())
        drawn.arithmetic = arithmetics.front();
    if (!supports(drawn.fillRule) && !fillRules.empty())
        drawn.fillRule = fillRules.front();
    for (const Variant variant : variantsIn(settings.variants)) {
        if (!supports(variant))
            drawn.variants = drawn.variants.without(variant);
    }
    if (!walksEdges())
        drawn.bugs = {};
    if (!testsEdges)
        drawn.testBugs = {};
    return drawn;
}

} // namespace pixelplumb
