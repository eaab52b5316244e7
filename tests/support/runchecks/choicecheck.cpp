// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/runchecks/runcheck.h"

#include <QStringList>

#include <set>

namespace pixelplumb {

namespace {

/// The settings of the runs that wrote a pixel.
struct Choices {
    std::set<Arithmetic> arithmetics;
    std::set<FillRule> fillRules;
    std::set<ByteRounding> roundings;
    std::set<FrameOrigin> origins;
    std::set<PixelCentre> centres;
};

void note(Choices &choices, const CheckedRun &run)
{
    if (run.traced->trace->writtenCount() == 0)
        return;
    const Scene &scene = run.traced->scene;
    choices.arithmetics.insert(scene.settings.arithmetic);
    choices.fillRules.insert(scene.settings.fillRule);
    choices.roundings.insert(scene.settings.rounding);
    choices.origins.insert(scene.frame.origin);
    choices.centres.insert(scene.frame.pixelCentre);
}

QString faultOfAll(const Method &method, const Choices &choices)
{
    QStringList missing;
    const auto compare = [&missing](const char *what, std::size_t seen, std::size_t all) {
        if (seen < all)
            missing += u"%1 of %2 %3"_s.arg(seen).arg(all).arg(QLatin1String(what));
    };
    compare("arithmetics", choices.arithmetics.size(), method.arithmetics.size());
    compare("fill rules", choices.fillRules.size(), method.fillRules.size());
    compare("roundings", choices.roundings.size(), allByteRoundings.size());
    compare("origins", choices.origins.size(), 2);
    compare("pixel centres", choices.centres.size(), 2);
    return missing.join(u", "_s);
}

} // namespace

RunCheck choiceCheck()
{
    const auto choices = std::make_shared<Choices>();
    return {u"every choice that the method leaves is in a run that writes"_s,
            [choices](const CheckedRun &run) {
                note(*choices, run);
                return QString();
            },
            [choices](const Method &method) { return faultOfAll(method, *choices); }};
}

} // namespace pixelplumb
