// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
#include "core/grade/showntext.h"
#include "core/lab/study/budget.h"
#include "core/lab/study/labfile.h"
#include "core/measure/timeleft.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/fileaccess.h"

#include <algorithm>

namespace pixelplumb::cli {

namespace {

const QString quickOption = QStringLiteral("quick");
const QString fullOption = QStringLiteral("full");
const QString familyOption = QStringLiteral("family");
const QString contenderOption = QStringLiteral("contender");
const QString accuracyOnlyOption = QStringLiteral("accuracy-only");
const QString budgetOption = QStringLiteral("budget");
const QString studyFormatOption = QStringLiteral("format");
const QString studyOption = QStringLiteral("output");
const QString ownSceneFamily = QStringLiteral("own-scene");

enum class LabFormat { Text, Csv, Json };

LabFormat chosenFormat(const CommandLine &line)
{
    const QString word = line.value(studyFormatOption);
    const QStringList names
        = {QStringLiteral("text"), QStringLiteral("csv"), QStringLiteral("json")};
    const qsizetype index = names.indexOf(word);
    if (index < 0)
        refuseUnknown(QStringLiteral("--format"), QStringLiteral("format"), word, names);
    if (line.isSet(accuracyOnlyOption) && LabFormat(index) == LabFormat::Text)
        refuse({QStringLiteral("--accuracy-only"), QStringLiteral("text tells of this machine"),
                QStringLiteral("--format json or csv")});
    return LabFormat(index);
}

QStringList chosenFamilies(const CommandLine &line)
{
    QStringList known;
    for (const LabFamilyInfo &info : labFamilies())
        known << QString::fromLatin1(info.id);
    QStringList families = line.value(familyOption).split(u',', Qt::SkipEmptyParts);
    for (const QString &family : families) {
        if (!known.contains(family))
            refuseUnknown(QStringLiteral("--family"), QStringLiteral("family"), family, known);
    }
    return families;
}

std::vector<LabContender> chosenContenders(const CommandLine &line)
{
    std::vector<LabContender> contenders;
    for (const QString &id : line.value(contenderOption).split(u',', Qt::SkipEmptyParts)) {
        const auto contender = labContenderNamed(id);
        if (!contender) {
            QStringList known;
            for (const LabContender &each : fullContenders())
                known << each.id;
            refuseUnknown(QStringLiteral("--contender"), QStringLiteral("contender"), id, known);
        }
        if (std::ranges::find(contenders, id, &LabContender::id) != contenders.end())
            refuse({QStringLiteral("--contender"), QStringLiteral("“%1” is named twice").arg(id),
                    QStringLiteral("each once")});
        contenders.push_back(*contender);
    }
    return contenders;
}

std::optional<Budget> chosenBudget(const CommandLine &line)
{
    if (!line.isSet(budgetOption))
        return std::nullopt;
    return chosen(line, budgetOption, allBudgets, allBudgets.front(), QStringLiteral("budget"));
}

StudySettings settingsFrom(const CommandLine &line)
{
    StudySettings settings;
    if (line.isSet(quickOption) && line.isSet(fullOption))
        refuse({{}, QStringLiteral("--quick and --full"), QStringLiteral("one of them")});
    settings.extent = line.isSet(fullOption) ? StudyExtent::Full : StudyExtent::Quick;
    if (line.isSet(accuracyOnlyOption)) {
        if (line.isSet(budgetOption))
            refuse({{},
                    QStringLiteral("--accuracy-only and --budget"),
                    QStringLiteral("one of them")});
        settings.rounds = 0;
    }
    const auto families = chosenFamilies(line);
    settings.families = families;
    settings.contenders = chosenContenders(line);
    settings.seed = chosenSeed(line);
    settings.hardCases = required(builtInHardCases());
    settings.ownSceneName = line.argument(0);
    if (settings.ownSceneName.isEmpty() && settings.families.contains(ownSceneFamily))
        refuse({QStringLiteral("SCENE"), QStringLiteral("is missing"),
                QStringLiteral("the scene that --family own-scene measures")});
    if (!settings.ownSceneName.isEmpty()) {
        const auto reading = readSceneAt(settings.ownSceneName);
        if (!reading.scene.hasTriangles())
            refuse({settings.ownSceneName,
                    QStringLiteral("has no triangles, which alone are measured"),
                    QStringLiteral("a scene with triangles")});
        settings.ownScene = std::make_shared<const Scene>(reading.scene);
    }
    return settings;
}

/// The family in which budgets are looked up: the scene, else random triangles, else the first
/// family requested.
QString familyOfBudget(const Study &study)
{
    for (const QString &id : {ownSceneFamily, QStringLiteral("random-integer")}) {
        if (study.family(id))
            return id;
    }
    return study.families.empty() ? QString() : study.families.front().id;
}

QByteArray accuracyBytesOf(const Study &study, LabFormat format)
{
    return format == LabFormat::Csv ? accuracyCsvOf(study) : writeAccuracy(study);
}

QByteArray bytesOf(const Study &study, LabFormat format)
{
    switch (format) {
    case LabFormat::Text:
        return shownLines(studyLines(study));
    case LabFormat::Csv:
        return csvOf(study);
    case LabFormat::Json:
        return escapedJson(writeStudy(study));
    }
    return {};
}

void addStudyOptions(CommandLine &line)
{
    line.addOption({quickOption,
                    QStringLiteral("Fifteen contenders within 20 seconds; this if "
                                   "left out.")});
    line.addOption({fullOption,
                    QStringLiteral("Every method in every arithmetic, within five "
                                   "minutes.")});
    addSeedOption(line, QStringLiteral("triangles"));
    line.addOption(
        {familyOption, QStringLiteral("These families alone: a,b."), QStringLiteral("names")});
    line.addOption({contenderOption,
                    QStringLiteral("These alone: column-scan:float32,column-scan:exact:fast."),
                    QStringLiteral("ids")});
    line.addOption({accuracyOnlyOption,
                    QStringLiteral("Time nothing and write the accuracy as JSON or CSV: the same "
                                   "seed, the same bytes.")});
    line.addOption({budgetOption,
                    QStringLiteral("Name the cheapest that meets it on the scene, or on random "
                                   "triangles: exact, 1-level, 10-ppm, 16-ms."),
                    QStringLiteral("budget")});
    line.addOption({studyFormatOption, QStringLiteral("text, csv or json; text if left out."),
                    QStringLiteral("format"), QStringLiteral("text")});
    line.addOption({{QStringLiteral("o"), studyOption},
                    QStringLiteral("Write to a file; - is standard output."),
                    QStringLiteral("file"),
                    QStringLiteral("-")});
}

Study runShowingTime(const StudySettings &settings)
{
    Progress progress;
    TimeLeft left(expectedSeconds(settings));
    StudyListener listener;
    const Interruption interruption;
    listener.progress = [&](const JobProgress &told) {
        left.tell(told, TimeLeft::Clock::now());
        progress.show(left.text());
        return !Interruption::isAsked();
    };
    return runStudy(settings, listener);
}

} // namespace

ExitCode lab(const Command &command, const QStringList &arguments)
{
    Positional scene = scenePositional();
    scene.presence = Positional::Presence::Optional;
    CommandLine line(command, {scene});
    addStudyOptions(line);
    line.parse(arguments);
    const LabFormat format = chosenFormat(line);
    const auto budget = chosenBudget(line);
    const StudySettings settings = settingsFrom(line);
    Output output(line.value(studyOption));
    output.open();

    const Study study = runShowingTime(settings);
    output.device().write(line.isSet(accuracyOnlyOption) ? accuracyBytesOf(study, format)
                                                         : bytesOf(study, format));
    output.finish();
    if (!study.isComplete) {
        sayLine(QStringLiteral("interrupted; what was measured until then is written"));
        return ExitCode::FallsShort;
    }
    if (!budget)
        return ExitCode::Done;
    const QString family = familyOfBudget(study);
    const BudgetAnswer answer = cheapestFor(*budget, study, family);
    sayLine(QStringLiteral("%1 on %2: %3").arg(textOf(*budget), family, answer.reason));
    return answer.ground == BudgetGround::Nobody ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
