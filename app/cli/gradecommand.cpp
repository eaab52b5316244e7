// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
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

const QString assignmentOption = u"assignment"_s;
const QString resultsOption = u"output"_s;
const QString pointsOption = u"points"_s;
const QString reasonOption = u"reason"_s;
const QString jobsOption = u"jobs"_s;

void addGradeOptions(CommandLine &line)
{
    line.addOption({assignmentOption, u"What was to be drawn, and for what points."_s, u"file"_s});
    line.addOption(
        {{u"o"_s, resultsOption},
         u"Write the results to this folder; those that are there already and still hold are kept. "
         "Several runs may share it."_s,
         u"folder"_s});
    line.addOption(
        {jobsOption,
         u"Grade this many submissions at once; as many as there are processors if left out."_s,
         u"number"_s});
    line.addRepeatedOption(
        {pointsOption,
         u"Give a submission these points in place of those of the checks, here and in later runs; "
         "NAME= alone takes them back. May be repeated."_s,
         u"NAME=points"_s});
    line.addOption({reasonOption, u"Why these points are given, for the student."_s, u"text"_s});
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
    const QString option = u"--"_s + pointsOption;
    for (const QString &word : line.values(pointsOption)) {
        const qsizetype equals = word.lastIndexOf(u'=');
        bool isNumber = false;
        const double points = QLocale::c().toDouble(word.mid(equals + 1), &isNumber);
        const bool isTakenBack = equals > 0 && equals + 1 == word.size();
        if (equals <= 0 || (!isTakenBack && !(isNumber && points >= 0 && points <= largestPoints)))
            refuse({option, u"“%1”"_s.arg(word),
                    u"NAME=POINTS, points from 0 to %1"_s.arg(largestPoints, 0, 'f', 0)});
        given.push_back({word.left(equals), isTakenBack ? std::nullopt : std::optional(points)});
    }
    const bool hasPoints = std::ranges::any_of(
        given, [](const GivenPoints &each) { return each.points.has_value(); });
    if (hasPoints && line.value(reasonOption).trimmed().isEmpty())
        refuse(u"--reason is missing: why the points of --points are given"_s);
    if (!hasPoints && line.isSet(reasonOption))
        refuse({u"--reason"_s, u"no points are given"_s, u"--points NAME=POINTS beside it"_s});
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
            refuse({u"--"_s + pointsOption, u"“%1” is no graded submission"_s.arg(each.name), {}});
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
        lines += u"partial: %1 more without a grade"_s.arg(report.missing.size());
    if (const QString text = unsandboxedText(report); !text.isEmpty())
        lines += text;
    for (const GradeCluster &cluster : clustersOf(report)) {
        lines += u"%1  %2"_s.arg(cluster.submissions.size(), 5).arg(cluster.title);
        for (const QString &sentence : cluster.forAssistant)
            lines += u"       "_s + sentence;
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
        clusters.append(
            QJsonObject{{u"cause"_s, cluster.title},
                        {u"student"_s, QJsonArray::fromStringList(cluster.forStudent)},
                        {u"assistant"_s, QJsonArray::fromStringList(cluster.forAssistant)},
                        {u"submissions"_s, names}});
    }
    QJsonObject object{{u"assignment"_s, report.assignment.name},
                       {u"submissions"_s, qint64(report.submissions.size())},
                       {u"missing"_s, QJsonArray::fromStringList(report.missing)},
                       {u"clusters"_s, clusters}};
    if (const QString text = unsandboxedText(report); !text.isEmpty())
        object.insert(u"noSandbox"_s, text);
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
        sayLine(u"%1: not graded, for their names begin with a dot: %2 (%3)"_s.arg(
            folder, QString::number(names.size()), fewNames(names)));
}

} // namespace

ExitCode grade(const Command &command, const QStringList &arguments)
{
    CommandLine line(command,
                     {{u"SUBMISSIONS"_s, u"a folder with a file or folder for each submission"_s},
                      {u"NAME"_s, u"a submission in it, to be graded without those not named"_s,
                       Positional::Presence::AnyNumber}});
    addGradeOptions(line);
    line.parse(arguments);
    if (line.value(resultsOption).isEmpty())
        refuse(u"-o is missing: the folder for the results"_s);
    refuseStandardOutput(line.value(resultsOption), u"a folder for the results"_s);
    if (line.argument(0) == u'-')
        refuse({u"-"_s, u"standard input is no folder"_s, u"a folder; one of that name is ./-"_s});
    if (!line.isSet(assignmentOption))
        refuse(u"--assignment is missing: the file that says what was to be drawn"_s);
    const Assignment assignment = readAssignmentAt(line.value(assignmentOption));
    if (assignment.points() == 0)
        sayLine(u"%1: all checks have 0 points: nothing is asked and everybody has 0"_s.arg(
            line.value(assignmentOption)));
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
        sayLine(u"interrupted; the same command goes on where it stopped"_s);
        return ExitCode::FallsShort;
    }
    if (!given.empty())
        refuse({u"--"_s + pointsOption, u"other runs are still grading; no points were given"_s,
                u"the same command once they have ended"_s});
    sayLine(
        u"%1: other runs are still grading; the last one writes the reports"_s.arg(order.results));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
