// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
#include "core/fast/machinethreads.h"
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradefolder.h"
#include "core/grade/class/gradereports.h"
#include "core/grade/class/submissionfolder.h"
#include "core/grade/showntext.h"
#include "core/scene/files/filepath.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

const QString assignmentOption = QStringLiteral("assignment");
const QString resultsOption = QStringLiteral("output");
const QString pointsOption = QStringLiteral("points");
const QString reasonOption = QStringLiteral("reason");
const QString jobsOption = QStringLiteral("jobs");

void addGradeOptions(CommandLine &line)
{
    line.addOption({assignmentOption, QStringLiteral("What was to be drawn, and for what points."),
                    QStringLiteral("file")});
    line.addOption({{QStringLiteral("o"), resultsOption},
                    QStringLiteral("Write the results to this folder; those that are there already "
                                   "and still hold are kept. Several runs may share it."),
                    QStringLiteral("folder")});
    line.addOption(
        {jobsOption,
         QStringLiteral(
             "Grade this many submissions at once; as many as there are processors if left out."),
         QStringLiteral("number")});
    line.addRepeatedOption(
        {pointsOption,
         QStringLiteral("Give a submission these points in place of those of the checks, here and "
                        "in later runs; NAME= alone takes them back. May be repeated."),
         QStringLiteral("NAME=points")});
    line.addOption({reasonOption, QStringLiteral("Why these points are given, for the student."),
                    QStringLiteral("text")});
    line.addJsonOption();
}

/// A submission's points by hand; none: those of its checks.
struct GivenPoints {
    QString name;
    std::optional<double> points;
};

std::vector<GivenPoints> givenPoints(const CommandLine &line)
{
    std::vector<GivenPoints> given;
    const QString option = QStringLiteral("--") + pointsOption;
    for (const QString &word : line.values(pointsOption)) {
        const qsizetype equals = word.lastIndexOf(u'=');
        bool isNumber = false;
        const double points = QLocale::c().toDouble(word.mid(equals + 1), &isNumber);
        const bool isTakenBack = equals > 0 && equals + 1 == word.size();
        if (equals <= 0 || (!isTakenBack && !(isNumber && points >= 0 && points <= largestPoints)))
            refuse(
                {option, QStringLiteral("“%1”").arg(word),
                 QStringLiteral("NAME=POINTS, points from 0 to %1").arg(largestPoints, 0, 'f', 0)});
        given.push_back({word.left(equals), isTakenBack ? std::nullopt : std::optional(points)});
    }
    const bool hasPoints = std::ranges::any_of(
        given, [](const GivenPoints &each) { return each.points.has_value(); });
    if (hasPoints && line.value(reasonOption).trimmed().isEmpty())
        refuse(QStringLiteral("--reason is missing: why the points of --points are given"));
    if (!hasPoints && line.isSet(reasonOption))
        refuse({QStringLiteral("--reason"), QStringLiteral("no points are given"),
                QStringLiteral("--points NAME=POINTS beside it")});
    return given;
}

/// Changes the reviews in the results and writes the reports again.
void give(const std::vector<GivenPoints> &given, const QString &reason, const QString &results,
          GradeReport &report)
{
    for (const GivenPoints &each : given) {
        const auto found
            = std::ranges::find(report.submissions, each.name, &GradedSubmission::name);
        if (found == report.submissions.end())
            refuse({QStringLiteral("--") + pointsOption,
                    QStringLiteral("“%1” is no graded submission").arg(each.name),
                    {}});
        found->review.points = each.points;
        found->review.reason = each.points ? std::optional(reason) : std::nullopt;
    }
    if (given.empty())
        return;
    refuseIf(writeReviews(results, report));
    refuseIf(writeReports(results, report));
}

/// Reads the assignment of a file, or of standard input for "-".
Assignment readAssignmentAt(const QString &path)
{
    return requiredIn(path, readAssignment(readInput(path), folderOf(path)));
}

/// A line per cluster, "12  unsorted-colours", and a summary.
QStringList clusterLines(const GradeReport &report)
{
    QStringList lines = {submissionsText(report.submissions.size())};
    if (!report.missing.isEmpty())
        lines += QStringLiteral("partial: %1 more without a grade").arg(report.missing.size());
    if (const QString text = unsandboxedText(report); !text.isEmpty())
        lines += text;
    for (const GradeCluster &cluster : clustersOf(report)) {
        lines += QStringLiteral("%1  %2").arg(cluster.submissions.size(), 5).arg(cluster.title);
        for (const QString &sentence : cluster.forAssistant)
            lines += QStringLiteral("       ") + sentence;
    }
    return lines;
}

QJsonObject clusterJson(const GradeReport &report)
{
    QJsonArray clusters;
    for (const GradeCluster &cluster : clustersOf(report)) {
        QJsonArray names;
        for (const std::size_t place : cluster.submissions)
            names.append(report.submissions[place].name);
        clusters.append(QJsonObject{
            {QStringLiteral("cause"), cluster.title},
            {QStringLiteral("student"), QJsonArray::fromStringList(cluster.forStudent)},
            {QStringLiteral("assistant"), QJsonArray::fromStringList(cluster.forAssistant)},
            {QStringLiteral("submissions"), names}});
    }
    QJsonObject object{{QStringLiteral("assignment"), report.assignment.name},
                       {QStringLiteral("submissions"), qint64(report.submissions.size())},
                       {QStringLiteral("missing"), QJsonArray::fromStringList(report.missing)},
                       {QStringLiteral("clusters"), clusters}};
    if (const QString text = unsandboxedText(report); !text.isEmpty())
        object.insert(QStringLiteral("noSandbox"), text);
    return object;
}

ExitCode print(const CommandLine &line, const GradeReport &report)
{
    line.asksForJson() ? printJson(clusterJson(report)) : printLines(clusterLines(report));
    const QStringList ungraded = ungradedLines(report);
    for (const QString &each : ungraded)
        sayLine(each);
    return ungraded.isEmpty() ? ExitCode::Done : ExitCode::Usage;
}

/// Reports names in the folder of submissions that are not graded because they begin with a dot.
void sayHidden(const QString &folder)
{
    QStringList names;
    for (const QByteArray &name : hiddenIn(folder))
        names += escapedName(name);
    if (!names.isEmpty())
        sayLine(QStringLiteral("%1: not graded, for their names begin with a dot: %2 (%3)")
                    .arg(folder, QString::number(names.size()), fewNames(names)));
}

} // namespace

ExitCode grade(const Command &command, const QStringList &arguments)
{
    CommandLine line(command,
                     {{QStringLiteral("SUBMISSIONS"),
                       QStringLiteral("a folder with a file or folder for each submission")},
                      {QStringLiteral("NAME"),
                       QStringLiteral("a submission in it, to be graded without those not named"),
                       Positional::Presence::AnyNumber}});
    addGradeOptions(line);
    line.parse(arguments);
    if (line.value(resultsOption).isEmpty())
        refuse(QStringLiteral("-o is missing: the folder for the results"));
    refuseStandardOutput(line.value(resultsOption), QStringLiteral("a folder for the results"));
    if (line.argument(0) == u'-')
        refuse({QStringLiteral("-"), QStringLiteral("standard input is no folder"),
                QStringLiteral("a folder; one of that name is ./-")});
    if (!line.isSet(assignmentOption))
        refuse(QStringLiteral("--assignment is missing: the file that says what was to be drawn"));
    const Assignment assignment = readAssignmentAt(line.value(assignmentOption));
    if (assignment.points() == 0)
        sayLine(QStringLiteral("%1: all checks have 0 points: nothing is asked and everybody has 0")
                    .arg(line.value(assignmentOption)));
    const std::vector<GivenPoints> given = givenPoints(line);
    const auto jobs = wholeNumberOf(line, jobsOption, {1, 256});
    const GradingOrder order{filePath(line.argument(0)), filePath(line.value(resultsOption)),
                             QCoreApplication::applicationVersion(),
                             int(jobs.value_or(threadsOfMachine())), line.arguments().mid(1)};
    sayHidden(line.argument(0));
    const Interruption interruption;
    auto report = required(withProgress([&](const ProgressListener &listener) {
        return gradeFolder(order, assignment, [&listener](const JobProgress &told) {
            return listener(told) && !Interruption::isAsked();
        });
    }));
    if (report) {
        give(given, line.value(reasonOption).trimmed(), order.results, *report);
        return print(line, *report);
    }
    if (Interruption::isAsked()) {
        sayLine(QStringLiteral("interrupted; the same command goes on where it stopped"));
        return ExitCode::FallsShort;
    }
    if (!given.empty())
        refuse({QStringLiteral("--") + pointsOption,
                QStringLiteral("other runs are still grading; no points were given"),
                QStringLiteral("the same command once they have ended")});
    sayLine(QStringLiteral("%1: other runs are still grading; the last one writes the reports")
                .arg(order.results));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
