// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/planreport.h"
#include "app/cli/sceneoptions.h"
#include "core/runs/sceneplan.h"

#include <QJsonDocument>

namespace pixelplumb::cli {

ExitCode plan(const Command &command, const QStringList &arguments)
{
    const QString jsonOption = QStringLiteral("json");
    CommandLine line(command, {scenePositional()});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const Result<Scene> scene = readSceneForAnyMethod(line, line.argument(0));
    if (!scene)
        return line.refuse(scene.error());
    const EffectPlan plan = planOf(*scene);
    const EffectForcing &forced = scene->appearance.forced;
    if (line.isSet(jsonOption)) {
        printLine(QString::fromUtf8(QJsonDocument(jsonOf(plan, forced)).toJson().chopped(1)));
    } else {
        const QStringList text = textOf(plan, forced);
        for (const QString &each : text)
            printLine(each);
    }
    if (const QString objection = objectionTo(*scene); !objection.isEmpty())
        sayLine(QStringLiteral("%1: method “%2” %3")
                    .arg(line.argument(0), QString::fromStdString(scene->method), objection));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
