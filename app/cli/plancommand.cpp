// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/planreport.h"
#include "app/cli/progress.h"
#include "app/cli/sceneoptions.h"
#include "core/runs/sceneplan.h"

namespace pixelplumb::cli {

ExitCode plan(const Command &command, const QStringList &arguments)
{
    const QString measureOption = QStringLiteral("measure");
    const QString jsonOption = QStringLiteral("json");
    CommandLine line(command, {scenePositional()});
    line.addOption({measureOption,
                    QStringLiteral("Measure, too, what each effect costs: it is drawn on and off "
                                   "in turn.")});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const Result<Scene> scene = readSceneForAnyMethod(line, line.argument(0));
    if (!scene)
        return line.refuse(scene.error());
    const auto refusal = refusalOf(*scene, line.argument(0));
    PlanReport report{planOf(*scene), scene->appearance.forced, std::nullopt,
                      refusal ? refusal->message() : QString()};
    if (line.isSet(measureOption) && !refusal)
        report.timing = withProgress([&scene](const ProgressListener &listener) {
            TimingOptions options;
            options.progress = listener;
            return timeEffects(*scene, options);
        });
    if (line.isSet(jsonOption))
        printJson(QJsonDocument(jsonOf(report)));
    else
        printLines(textOf(report));
    if (refusal)
        sayLine(refusal->message());
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
