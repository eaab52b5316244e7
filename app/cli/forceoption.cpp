// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/forceoption.h"

#include "app/cli/suggestion.h"
#include "core/scan/choicenames.h"

namespace pixelplumb::cli {

namespace {

constexpr QLatin1String forceOption("force");

/// The effects' names as one word each: "smooth-colour".
QStringList effectWords()
{
    return namesOf(allEffects).replaceInStrings(QStringLiteral(" "), QStringLiteral("-"));
}

} // namespace

void addForceOption(CommandLine &line)
{
    line.addOption({forceOption,
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
        const qsizetype index = effectWords().indexOf(name);
        if (index < 0)
            return unknownName(place, QStringLiteral("effect"), name, effectWords());
        if (state != QStringLiteral("on") && state != QStringLiteral("off"))
            return InputError{place, QStringLiteral("“%1”").arg(entry),
                              QStringLiteral("%1=on or %1=off").arg(name)};
        const Effect effect = allEffects[std::size_t(index)];
        if (effect == Effect::Clipping)
            return InputError{place,
                              QStringLiteral("clipping has no switch: the frame's border bounds "
                                             "every loop, at no cost"),
                              {}};
        forced[effect] = state == QStringLiteral("on") ? Forcing::On : Forcing::Off;
    }
    return forced;
}

} // namespace pixelplumb::cli
