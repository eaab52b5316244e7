// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost/effectstext.h"

#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

struct EffectsText {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::EffectsText)
};

/// Whether forcing the effect on leaves the picture unchanged where it is not called for.
bool isNeutral(Effect effect, const Appearance &appearance, Arithmetic arithmetic)
{
    switch (effect) {
    case Effect::SmoothColour:
    case Effect::Perspective:
    case Effect::Blending:
        return true;
    case Effect::Depth:
        // Rounded depths may be in another order.
        return appearance.depth == DepthUse::Auto && arithmetic == Arithmetic::Exact;
    case Effect::Clipping:
    case Effect::Texture:
    case Effect::Light:
    case Effect::Antialiasing:
        break;
    }
    return false;
}

/// The only forced effect; none where several are, since a change cannot then be attributed.
std::optional<Effect> onlyForced(const EffectForcing &forced)
{
    std::optional<Effect> only;
    for (const Effect effect : allEffects) {
        if (forced[effect] == Forcing::AsCalledFor)
            continue;
        if (only)
            return std::nullopt;
        only = effect;
    }
    return only;
}

QString forcedWords(const EffectPlan &plan, Effect effect, Forcing forcing)
{
    const QString name = coreWord(nameOf(effect));
    if (forcing == Forcing::Off)
        return EffectsText::tr("%1 off").arg(name);
    return plan.runs(effect) ? EffectsText::tr("%1 on").arg(name)
                             : EffectsText::tr("%1 on, where there is none to switch on").arg(name);
}

QString contradictionText(const EffectPlan &plan, const Appearance &appearance,
                          Arithmetic arithmetic, std::int64_t changed)
{
    const std::optional<Effect> effect = onlyForced(appearance.forced);
    if (!effect)
        return {};
    const QString name = coreWord(nameOf(*effect));
    const Verdict verdict = plan.verdicts[*effect].verdict;
    const bool isOff = appearance.forced[*effect] == Forcing::Off;
    if (isOff && verdict == Verdict::CalledFor && changed == 0)
        return EffectsText::tr("No pixel needs %1 here. That the plan calls for it is a "
                               "defect, unless its values differ by less than a byte.")
            .arg(name);
    if (isOff && verdict == Verdict::NotCalledFor && changed > 0)
        return EffectsText::tr("A defect: %1 is not called for, and pixels change without it.")
            .arg(name);
    if (!isOff && verdict == Verdict::NotCalledFor && changed > 0
        && isNeutral(*effect, appearance, arithmetic))
        return EffectsText::tr("A defect: %1 is not called for, and pixels change with it.")
            .arg(name);
    return {};
}

} // namespace

QString verdictText(Verdict verdict)
{
    const QString glyph = verdict == Verdict::CalledFor ? u"● "_s
        : verdict == Verdict::NotCalledFor              ? u"○ "_s
                                                        : u"? "_s;
    return glyph + coreWord(nameOf(verdict));
}

QString forcingText(const EffectPlan &plan, const Appearance &appearance, Arithmetic arithmetic,
                    std::int64_t changed)
{
    QStringList words;
    for (const Effect effect : allEffects) {
        if (appearance.forced[effect] != Forcing::AsCalledFor)
            words.append(forcedWords(plan, effect, appearance.forced[effect]));
    }
    if (words.empty())
        return {};
    const QString changes = changed == 0
        ? EffectsText::tr("no pixel changes")
        : EffectsText::tr("%n pixels change, marked on the canvas", nullptr, int(changed));
    return QStringList{EffectsText::tr("Forced: %1; %2.").arg(words.join(u", "_s), changes),
                       contradictionText(plan, appearance, arithmetic, changed)}
        .join(u' ')
        .trimmed();
}

QString ratioText(const Spread &ratio)
{
    return u"%1 (%2 … %3)"_s.arg(ratio.median, 0, 'f', 2)
        .arg(ratio.lower, 0, 'f', 2)
        .arg(ratio.upper, 0, 'f', 2);
}

} // namespace pixelplumb
