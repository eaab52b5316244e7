// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/forceoption.h"

#include "app/cli/suggestion.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb::cli {

namespace {

constexpr QLatin1String forceOption("force");

/// "smooth-colour".
QString wordOf(Effect effect) { return nameText(nameOf(effect)).replace(u' ', u'-'); }

/// The words of the effects that have a switch.
QStringList effectWords()
{
    QStringList words;
    for (const Effect effect : allEffects) {
        if (effect != Effect::Clipping)
            words.append(wordOf(effect));
    }
    return words;
}

} // namespace

void addForceOption(CommandLine &line)
{
    line.addRepeatedOption(
        {forceOption,
         QStringLiteral("Switch an effect on or off whatever the scene calls for: ")
             + effectWords().join(QStringLiteral(", "))
             + QStringLiteral(", each with =on or =off. May be repeated."),
         QStringLiteral("effect=on|off")});
}

Result<EffectForcing> chosenForcing(const CommandLine &line)
{
    const QString place = QStringLiteral("--") + forceOption;
    EffectForcing forced;
    for (const QString &entry : line.values(forceOption)) {
        const QString name = entry.section(u'=', 0, 0);
        const QString state = entry.section(u'=', 1);
        if (name == wordOf(Effect::Clipping))
            return InputError{place,
                              QStringLiteral("clipping has no switch: the frame's border bounds "
                                             "every loop, at no cost"),
                              {}};
        const auto found = std::ranges::find(allEffects, name, wordOf);
        if (found == allEffects.end())
            return unknownName(place, QStringLiteral("effect"), name, effectWords());
        if (state != QStringLiteral("on") && state != QStringLiteral("off"))
            return InputError{place, QStringLiteral("“%1”").arg(entry),
                              QStringLiteral("%1=on or %1=off").arg(name)};
        const Forcing forcing = state == QStringLiteral("on") ? Forcing::On : Forcing::Off;
        if (forced[*found] != Forcing::AsCalledFor && forced[*found] != forcing)
            return InputError{place, QStringLiteral("%1=on and %1=off").arg(name),
                              QStringLiteral("one of them")};
        forced[*found] = forcing;
    }
    return forced;
}

} // namespace pixelplumb::cli
