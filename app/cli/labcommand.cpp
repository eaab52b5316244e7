// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/grade/showntext.h"
#include "core/lab/study/budget.h"
#include "core/lab/study/labfile.h"
#include "core/measure/timeleft.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/fileaccess.h"

#include <algorithm>

namespace pixelplumb::cli {

namespace {

const QString quickOption = u"quick"_s;
const QString fullOption = u"full"_s;
const QString familyOption = u"family"_s;
const QString contenderOption = u"contender"_s;
const QString accuracyOnlyOption = u"accuracy-only"_s;
const QString budgetOption = u"budget"_s;
const QString studyOption = u"output"_s;
const QString ownSceneFamily = u"own-scene"_s;

TableFormat chosenFormat(const CommandLine &line)
{
    const TableFormat format = chosenTableFormat(line, TableFormat::Text);
    if (line.isSet(accuracyOnlyOption) && format == TableFormat::Text)
        refuse({u"--accuracy-only"_s, u"text tells of this machine"_s, u"--format json or csv"_s});
    return format;
}

QStringList chosenFamilies(const CommandLine &line)
{
    QStringList known;
    for (const LabFamilyInfo &info : labFamilies())
        known << QString::fromLatin1(info.id);
    QStringList families = line.value(familyOption).split(u',', Qt::SkipEmptyParts);
    for (const QString &family : families) {
        if (!known.contains(family))
            refuseUnknown(u"--family"_s, u"family"_s, family, known);
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
            refuseUnknown(u"--contender"_s, u"contender"_s, id, known);
        }
        if (std::ranges::find(contenders, id, &LabContender::id) != contenders.end())
            refuse({u"--contender"_s, u"“%1” is named twice"_s.arg(id), u"each once"_s});
        contenders.push_back(*contender);
    }
    return contenders;
}

std::optional<Budget> chosenBudget(const CommandLine &line)
{
    if (!line.isSet(budgetOption))
        return std::nullopt;
    return chosen(line, budgetOption, allBudgets, allBudgets.front(), u"budget"_s);
}

StudySettings settingsFrom(const CommandLine &line)
{
    StudySettings settings;
    if (line.isSet(quickOption) && line.isSet(fullOption))
        refuse({{}, u"--quick and --full"_s, u"one of them"_s});
    settings.extent = line.isSet(fullOption) ? StudyExtent::Full : StudyExtent::Quick;
    if (line.isSet(accuracyOnlyOption)) {
        if (line.isSet(budgetOption))
            refuse({{}, u"--accuracy-only and --budget"_s, u"one of them"_s});
        settings.rounds = 0;
    }
    const auto families = chosenFamilies(line);
    settings.families = families;
    settings.contenders = chosenContenders(line);
    settings.seed = chosenSeed(line);
    settings.hardCases = required(builtInHardCases());
    settings.ownSceneName = line.argument(0);
    if (settings.ownSceneName.isEmpty() && settings.families.contains(ownSceneFamily))
        refuse({u"SCENE"_s, u"is missing"_s, u"the scene that --family own-scene measures"_s});
    if (!settings.ownSceneName.isEmpty()) {
        const auto reading = readSceneAt(settings.ownSceneName);
        if (!reading.scene.hasTriangles())
            refuse({settings.ownSceneName, u"has no triangles, which alone are measured"_s,
                    u"a scene with triangles"_s});
        settings.ownScene = std::make_shared<const Scene>(reading.scene);
    }
    return settings;
}

/// The family in which budgets are looked up: the scene, else random triangles, else the first
/// family requested.
QString familyOfBudget(const Study &study)
{
    for (const QString &id : {ownSceneFamily, u"random-integer"_s}) {
        if (study.family(id))
            return id;
    }
    return study.families.empty() ? QString() : study.families.front().id;
}

QByteArray accuracyBytesOf(const Study &study, TableFormat format)
{
    return format == TableFormat::Csv ? accuracyCsvOf(study) : writeAccuracy(study);
}

QByteArray bytesOf(const Study &study, TableFormat format)
{
    switch (format) {
    case TableFormat::Text:
        return shownLines(studyLines(study));
    case TableFormat::Csv:
        return csvOf(study);
    case TableFormat::Json:
        return escapedJson(writeStudy(study));
    }
    return {};
}

void addStudyOptions(CommandLine &line)
{
    line.addOption({quickOption, u"Fifteen contenders within 20 seconds; this if left out."_s});
    line.addOption({fullOption, u"Every method in every arithmetic, within five minutes."_s});
    addSeedOption(line, u"triangles"_s);
    line.addOption({familyOption, u"These families alone: a,b."_s, u"names"_s});
    line.addOption(
        {contenderOption, u"These alone: column-scan:float32,column-scan:exact:fast."_s, u"ids"_s});
    line.addOption(
        {accuracyOnlyOption,
         u"Time nothing and write the accuracy as JSON or CSV: the same seed, the same bytes."_s});
    line.addOption(
        {budgetOption,
         u"Name the cheapest that meets it on the scene, or on random triangles: exact, 1-level, "
         "10-ppm, 16-ms."_s,
         u"budget"_s});
    line.addOption(
        {u"format"_s, u"text, csv or json; text if left out."_s, u"format"_s, u"text"_s});
    line.addOption(
        {{u"o"_s, studyOption}, u"Write to a file; - is standard output."_s, u"file"_s, u"-"_s});
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
    const TableFormat format = chosenFormat(line);
    const auto budget = chosenBudget(line);
    const StudySettings settings = settingsFrom(line);
    Output output(line.value(studyOption));
    output.open();

    const Study study = runShowingTime(settings);
    output.device().write(line.isSet(accuracyOnlyOption) ? accuracyBytesOf(study, format)
                                                         : bytesOf(study, format));
    output.finish();
    if (!study.isComplete) {
        sayLine(u"interrupted; what was measured until then is written"_s);
        return ExitCode::FallsShort;
    }
    if (!budget)
        return ExitCode::Done;
    const QString family = familyOfBudget(study);
    const BudgetAnswer answer = cheapestFor(*budget, study, family);
    sayLine(u"%1 on %2: %3"_s.arg(textOf(*budget), family, answer.reason));
    return answer.ground == BudgetGround::Nobody ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
