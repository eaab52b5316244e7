// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/options.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/hunt/trial.h"
#include "core/grade/showntext.h"

#include <QJsonArray>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

constexpr qsizetype longestMessages = 400; // characters of stderr
const QString nothingToCompare
    = QStringLiteral("nothing was printed that could be compared: it names triangles, and none of "
                     "their lines has numbers");

/// A scene's file and the result of the trial.
struct SceneTrial {
    QString path;
    Scene scene;
    Trial trial;
};

QString stepText(const TraceDifference &difference)
{
    return QStringLiteral("%1 (step %2 of %3)")
        .arg(difference.text, QString::number(difference.step + 1),
             QString::fromStdString(difference.scene.method));
}

QStringList linesOf(const SceneTrial &tried)
{
    const Trial &trial = tried.trial;
    QStringList lines = {tried.path + QStringLiteral(": ") + trial.run.told};
    if (trial.fault && trial.run.end == ProgramEnd::Finished)
        lines += QStringLiteral("    ") + trial.fault->message();
    if (trial.picture) {
        if (trial.output.picture->isTransparent)
            lines += QStringLiteral("    its picture ") + transparencyText();
        for (const QString &line : diffLines(*trial.picture))
            lines += QStringLiteral("    ") + line;
    }
    if (const auto beyond = beyondFrameText(trial.output))
        lines += QStringLiteral("    ") + *beyond;
    if (trial.hasNothingToCompare())
        lines += QStringLiteral("    ") + nothingToCompare;
    if (trial.trace)
        lines += QStringLiteral("    first difference: ") + stepText(*trial.trace);
    else if (trial.output.hasLines() && !trial.fault)
        lines += QStringLiteral("    no number of its trace differs");
    const QString said = shownText(trial.run.messages, longestMessages).trimmed();
    if (!said.isEmpty()) {
        lines += QStringLiteral("    it said:");
        for (const QString &line : said.split(u'\n'))
            lines += QStringLiteral("        ") + line;
    }
    return lines;
}

QJsonObject objectOf(const SceneTrial &tried)
{
    const Trial &trial = tried.trial;
    QJsonObject object{{QStringLiteral("scene"), tried.path},
                       {QStringLiteral("right"), trial.isRight()},
                       {QStringLiteral("end"), nameOf(trial.run.end)},
                       {QStringLiteral("code"), trial.run.code},
                       {QStringLiteral("told"), trial.run.told},
                       {QStringLiteral("messages"), shownText(trial.run.messages, longestMessages)},
                       {QStringLiteral("sandbox"), trial.run.isSandboxed()}};
    if (trial.fault)
        object.insert(QStringLiteral("fault"), trial.fault->message());
    else if (trial.hasNothingToCompare())
        object.insert(QStringLiteral("fault"), nothingToCompare);
    if (trial.output.trace)
        object.insert(QStringLiteral("beyondFrame"), qint64(trial.output.trace->beyondFrame));
    if (trial.picture)
        object.insert(QStringLiteral("picture"), diffJson(*trial.picture));
    object.insert(QStringLiteral("transparencyIgnored"),
                  trial.output.picture && trial.output.picture->isTransparent);
    if (trial.trace)
        object.insert(QStringLiteral("parts"),
                      QJsonObject{{QStringLiteral("how"), trial.trace->text},
                                  {QStringLiteral("step"), qint64(trial.trace->step + 1)},
                                  {QStringLiteral("method"),
                                   QString::fromStdString(trial.trace->scene.method)}});
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
    line.addRepeatedOption({QStringLiteral("scene"),
                            QStringLiteral("A scene that the program is to draw; may be repeated."),
                            QStringLiteral("file")});
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
        return QStringLiteral("right");
    return QStringLiteral("undecidable: %1 %2, as a right program may have it")
        .arg(open)
        .arg(open == 1 ? QStringLiteral("pixel differs") : QStringLiteral("pixels differ"));
}

/// The programs that did not end well, and how they ended; none where all did.
QStringList badEndsOf(const std::vector<SceneTrial> &tried)
{
    QStringList ends;
    for (const SceneTrial &each : tried) {
        if (each.trial.run.end != ProgramEnd::Finished)
            ends += each.path + QStringLiteral(": ") + each.trial.run.told;
    }
    if (ends.empty())
        return {};
    return {QStringLiteral("did not end well on %1 of %2 scenes: %3")
                .arg(ends.size())
                .arg(tried.size())
                .arg(ends.join(QStringLiteral("; ")))};
}

/// The verdict where a trace tells of a mistake that no picture shows.
QStringList tracedVerdict(const std::vector<SceneTrial> &tried, const Diagnosis &diagnosis)
{
    const auto count = std::ranges::count_if(
        tried, [](const SceneTrial &each) { return each.trial.trace.has_value(); });
    if (diagnosis.verdict == DiagnosisVerdict::Wrong || count == 0)
        return {};
    return {QStringLiteral("wrong: %1 differs, though no picture shows it")
                .arg(count == 1 ? QStringLiteral("a trace")
                                : QStringLiteral("the trace of %1 scenes").arg(count))};
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
    CommandLine line(command,
                     {{QStringLiteral("PROGRAM"),
                       QStringLiteral("a program and its arguments, after -- where one of them "
                                      "begins with -"),
                       Positional::Presence::Command}});
    addTrialOptions(line);
    addSettingOptions(line);
    line.parse(arguments);
    const TrialTerms terms = termsOf(line);
    const QStringList scenes = line.values(QStringLiteral("scene"));
    if (scenes.isEmpty())
        refuse(QStringLiteral("--scene FILE is missing: what the program is to draw"));
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
        QJsonObject report{{QStringLiteral("right"), areRight}, {QStringLiteral("trials"), trials}};
        if (diagnosis)
            report.insert(QStringLiteral("diagnosis"), diagnosisJson(*diagnosis, submissions));
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
