// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefolder.h"

#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradereports.h"
#include "core/grade/class/resultslock.h"
#include "core/grade/class/sharedgrading.h"
#include "core/grade/class/submissionfolder.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/files/outputfolder.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

/// Removes the results of submissions that no longer exist, and what ended runs left unfinished.
void removeOthers(const ResultsFolder &results, const Assignment &assignment,
                  const QString &submissions)
{
    const Result<std::vector<QByteArray>> names = submissionsIn(submissions);
    if (!names)
        return;
    QSet<QString> kept;
    for (const QByteArray &name : *names) {
        const QString id = idOf(name);
        kept += id + u".json"_s;
        for (const AssignedScene &scene : assignment.scenes) {
            for (const char *end : {"png", "txt"})
                kept += u"%1-%2.%3"_s.arg(id, scene.name, QLatin1String(end));
        }
    }
    for (const QString &folder : ResultsFolder::folders()) {
        for (const QString &file : results.filesIn(folder)) {
            if (!kept.contains(file))
                results.remove(folder + u'/' + file);
        }
    }
    const QRegularExpression unfinished(
        u"^(%1)\\.[0-9a-f]{8}$"_s.arg(resultFiles().join(u'|').replace(u'.', "\\.")));
    for (const QString &file : results.filesIn({})) {
        if (unfinished.match(file).hasMatch())
            results.remove(file);
    }
}

/// Results inside the submissions, or the reverse, would be mixed up.
std::optional<InputError> refusalOf(const GradingOrder &order)
{
    if (!lieInEachOther(order.results, order.submissions))
        return std::nullopt;
    return InputError{order.results, u"results and submissions lie in each other's folders"_s,
                      u"a folder of their own for the results"_s};
}

/// The submissions to be graded. They may be ordered by the names that reports show, too, where
/// bytes that are no plain characters are escaped.
Result<std::vector<QByteArray>> orderedIn(const GradingOrder &order,
                                          const std::vector<QByteArray> &names)
{
    if (order.names.isEmpty())
        return names;
    std::vector<QByteArray> ordered;
    for (const QString &word : order.names) {
        const auto found = std::ranges::find_if(names, [&](const QByteArray &name) {
            return name == QFile::encodeName(word) || escapedName(name) == word;
        });
        if (found == names.end())
            return InputError{word, u"is no submission in %1"_s.arg(order.submissions),
                              u"the name of a file or folder there"_s};
        ordered.push_back(*found);
    }
    return ordered;
}

/// Makes the folder of results, or resumes an existing one, beside other runs of the assignment. An
/// error where a run of another one is at work.
Result<ResultsLock> beginResults(const ResultsFolder &results, const QByteArray &assignment,
                                 const QByteArray &submissionList)
{
    auto lock = ResultsLock::of(results);
    if (!lock)
        return lock;
    const auto isAssigned = [&] {
        const Result<QByteArray> written = results.read(assignmentFile);
        return written && *written == assignment;
    };
    if (!lock->takeAlone()) {
        lock->share();
        if (!isAssigned() && !lock->takeAlone())
            return InputError{results.pathOf(assignmentFile),
                              u"is of another run, which is still grading"_s,
                              u"its end, or another folder for this assignment"_s};
    }
    if (auto error = results.makeFolders())
        return *error;
    if (auto error = results.write(submissionListFile, submissionList))
        return *error;
    if (!isAssigned()) {
        if (auto error = results.write(assignmentFile, assignment))
            return *error;
    }
    lock->share();
    return lock;
}

} // namespace

Result<std::optional<GradeReport>> gradeFolder(const GradingOrder &order,
                                               const Assignment &assignment,
                                               const ProgressListener &listener)
{
    const Result<std::vector<QByteArray>> all = submissionsIn(order.submissions);
    if (!all)
        return all.error();
    QStringList list;
    for (const QByteArray &name : *all)
        list += escapedName(name);
    list.sort();
    Result<std::vector<QByteArray>> names = orderedIn(order, *all);
    if (!names)
        return names.error();
    if (auto error = refusalOf(order))
        return *error;
    if (auto error = noteInputFolder(order.submissions))
        return *error;
    if (auto error = refusalOfFolder(order.results))
        return *error;
    const ResultsFolder results(order.results);
    if (auto error = refusalOfResults(results))
        return *error;
    auto lock = beginResults(results, writeAssignment(assignment), writeSubmissionList(list));
    if (!lock)
        return lock.error();
    { // Frees what it knows of pictures before the reports.
        SharedGrading grading(order, assignment, *lock, listener);
        do {
            lock->share();
            *names = grading.run(std::move(*names));
            if (grading.error())
                return *grading.error();
            if (grading.isStopped())
                return std::optional<GradeReport>();
            lock->leave();
            if (!lock->takeAlone())
                return std::optional<GradeReport>();
        } while (!names->empty()); // their runs have ended, perhaps before they were graded
    }
    removeOthers(results, assignment, order.submissions);
    Result<GradeReport> report = readGrades(order.results);
    if (!report)
        return report.error();
    if (auto error = writeReports(order.results, *report))
        return *error;
    return std::optional(std::move(*report));
}

} // namespace pixelplumb
