// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/hunt/trial.h"
#include "core/grade/showntext.h"

#include <QJsonArray>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

constexpr qsizetype longestMessages = 400; // characters of stderr
const QString nothingToCompare
    = u"nothing was printed that could be compared: it names triangles, and none of their lines "
      "has numbers"_s;

/// A scene's file and the result of the trial.
struct SceneTrial {
    QString path;
    Scene scene;
    Trial trial;
};

QString stepText(const TraceDifference &difference)
{
    return u"%1 (step %2 of %3)"_s.arg(difference.text, QString::number(difference.step + 1),
                                       QString::fromStdString(difference.scene.method));
}

QStringList linesOf(const SceneTrial &tried)
{
    const Trial &trial = tried.trial;
    QStringList lines = {tried.path + u": "_s + trial.run.told};
    if (trial.fault && trial.run.end == ProgramEnd::Finished)
        lines += u"    "_s + trial.fault->message();
    if (trial.picture) {
        if (trial.output.picture->isTransparent)
            lines += u"    its picture "_s + transparencyText();
        for (const QString &line : diffLines(*trial.picture))
            lines += u"    "_s + line;
    }
    if (const auto beyond = beyondFrameText(trial.output))
        lines += u"    "_s + *beyond;
    if (trial.hasNothingToCompare())
        lines += u"    "_s + nothingToCompare;
    if (trial.trace)
        lines += u"    first difference: "_s + stepText(*trial.trace);
    else if (trial.output.hasLines() && !trial.fault)
        lines += u"    no number of its trace differs"_s;
    const QString said = shownText(trial.run.messages, longestMessages).trimmed();
    if (!said.isEmpty()) {
        lines += u"    it said:"_s;
        for (const QString &line : said.split(u'\n'))
            lines += u"        "_s + line;
    }
    return lines;
}

QJsonObject objectOf(const SceneTrial &tried)
{
    const Trial &trial = tried.trial;
    QJsonObject object{{u"scene"_s, tried.path},
                       {u"right"_s, trial.isRight()},
                       {u"end"_s, nameOf(trial.run.end)},
                       {u"code"_s, trial.run.code},
                       {u"told"_s, trial.run.told},
                       {u"messages"_s, shownText(trial.run.messages, longestMessages)},
                       {u"sandbox"_s, trial.run.isSandboxed()}};
    if (trial.fault)
        object.insert(u"fault"_s, trial.fault->message());
    else if (trial.hasNothingToCompare())
        object.insert(u"fault"_s, nothingToCompare);
    if (trial.output.trace)
        object.insert(u"beyondFrame"_s, qint64(trial.output.trace->beyondFrame));
    if (trial.picture)
        object.insert(u"picture"_s, diffJson(*trial.picture));
    object.insert(u"transparencyIgnored"_s,
                  trial.output.picture && trial.output.picture->isTransparent);
    if (trial.trace)
        object.insert(
            u"parts"_s,
            QJsonObject{{u"how"_s, trial.trace->text},
                        {u"step"_s, qint64(trial.trace->step + 1)},
                        {u"method"_s, QString::fromStdString(trial.trace->scene.method)}});
    return object;
}

TrialTerms termsOf(const CommandLine &line)
{
    TrialTerms terms = chosenTerms(line);
    terms.margin = chosenMargin(line);
    return terms;
}

void addTrialOptions(CommandLine &line)
{
    line.addRepeatedOption(
        {u"scene"_s, u"A scene that the program is to draw; may be repeated."_s, u"file"_s});
    addProgramOptions(line);
    addMarginOptions(line);
    line.addJsonOption();
}

/// The verdict on trials without errors, in diagnose's words.
QString verdictOf(const std::vector<SceneTrial> &tried)
{
    std::int64_t open = 0;
    for (const SceneTrial &each : tried)
        open += each.trial.picture ? each.trial.picture->count(Difference::Undecidable) : 0;
    if (open == 0)
        return u"right"_s;
    return u"undecidable: %1 %2, as a right program may have it"_s.arg(open).arg(
        open == 1 ? u"pixel differs"_s : u"pixels differ"_s);
}

/// The programs that did not end well, and how they ended; none where all did.
QStringList badEndsOf(const std::vector<SceneTrial> &tried)
{
    QStringList ends;
    for (const SceneTrial &each : tried) {
        if (each.trial.run.end != ProgramEnd::Finished)
            ends += each.path + u": "_s + each.trial.run.told;
    }
    if (ends.empty())
        return {};
    return {u"did not end well on %1 of %2 scenes: %3"_s.arg(ends.size())
                .arg(tried.size())
                .arg(ends.join(u"; "_s))};
}

/// The verdict where a trace tells of a mistake that no picture shows.
QStringList tracedVerdict(const std::vector<SceneTrial> &tried, const Diagnosis &diagnosis)
{
    const auto count = std::ranges::count_if(
        tried, [](const SceneTrial &each) { return each.trial.trace.has_value(); });
    if (diagnosis.verdict == DiagnosisVerdict::Wrong || count == 0)
        return {};
    return {u"wrong: %1 differs, though no picture shows it"_s.arg(
        count == 1 ? u"a trace"_s : u"the trace of %1 scenes"_s.arg(count))};
}

/// The diagnosis of all pictures together; none without pictures, or if all are right.
std::optional<Diagnosis> diagnosisOf(const std::vector<Submission> &submissions, bool isRight,
                                     const Margin &margin)
{
    if (isRight || submissions.empty())
        return std::nullopt;
    return withProgress(
        [&](const ProgressListener &listener) { return diagnose(submissions, listener, margin); });
}

} // namespace

ExitCode tryProgram(const Command &command, const QStringList &arguments)
{
    CommandLine line(
        command,
        {{u"PROGRAM"_s, u"a program and its arguments, after -- where one of them begins with -"_s,
          Positional::Presence::Command}});
    addTrialOptions(line);
    addSettingOptions(line);
    line.parse(arguments);
    const TrialTerms terms = termsOf(line);
    const QStringList scenes = line.values(u"scene"_s);
    if (scenes.isEmpty())
        refuse(u"--scene FILE is missing: what the program is to draw"_s);
    const StudentProgram student = required(studentProgramOf(line.arguments()));
    std::vector<SceneTrial> tried;
    std::vector<Submission> submissions;
    for (const QString &path : scenes) {
        Scene scene = readScene(line, path).scene;
        refuseToJudgeBy(scene, path);
        Result<Trial> trial = pixelplumb::tryProgram(student, scene, terms);
        if (!trial)
            refuse({path, trial.error().message(), {}});
        if (trial->output.picture)
            submissions.push_back({judgedScene(scene, terms.margin), *trial->output.picture});
        tried.push_back({path, std::move(scene), std::move(*trial)});
    }
    const auto isRight = [](const SceneTrial &each) { return each.trial.isRight(); };
    const bool areRight = std::ranges::all_of(tried, isRight);
    const auto diagnosis = diagnosisOf(submissions, areRight, terms.margin);
    if (line.asksForJson()) {
        QJsonArray trials;
        for (const SceneTrial &each : tried)
            trials.append(objectOf(each));
        QJsonObject report{{u"right"_s, areRight}, {u"trials"_s, trials}};
        if (diagnosis)
            report.insert(u"diagnosis"_s, diagnosisJson(*diagnosis, submissions));
        addConfinement(report);
        printJson(report);
    } else {
        for (const SceneTrial &each : tried)
            printLines(linesOf(each));
        const QStringList traced = diagnosis ? tracedVerdict(tried, *diagnosis) : QStringList();
        if (diagnosis)
            printLines(traced.isEmpty() ? diagnosisLines(*diagnosis, submissions) : traced);
        else if (areRight)
            printLine(verdictOf(tried));
        printLines(confinementLines() + badEndsOf(tried));
    }
    return areRight ? ExitCode::Done : ExitCode::FallsShort;
}

} // namespace pixelplumb::cli
