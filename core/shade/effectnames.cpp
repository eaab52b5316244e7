// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/choicenames.h"
#include "core/shade/effectplan.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

std::string_view nameOf(Verdict verdict)
{
    switch (verdict) {
    case Verdict::NotCalledFor:
        return QT_TRANSLATE_NOOP("core", "not called for");
    case Verdict::CalledFor:
        return QT_TRANSLATE_NOOP("core", "called for");
    case Verdict::NotRuledOut:
        return QT_TRANSLATE_NOOP("core", "not ruled out");
    }
    return {};
}

bool contains(const EffectSet &effects, Effect effect)
{
    switch (effect) {
    case Effect::SmoothColour:
        return effects.smooth;
    case Effect::Depth:
        return effects.depth != DepthTest::None;
    case Effect::Perspective:
        return effects.perspective;
    case Effect::Texture:
        return effects.texture;
    case Effect::Light:
        return effects.light;
    case Effect::Blending:
        return effects.blending;
    case Effect::Clipping:
    case Effect::Antialiasing:
        break;
    }
    return false;
}

QString namesOf(const EffectSet &effects)
{
    QStringList names;
    for (const Effect effect : allEffects) {
        if (contains(effects, effect))
            names.append(nameText(nameOf(effect)));
    }
    return names.empty() ? u"one colour"_s : names.join(u", "_s);
}

} // namespace pixelplumb
