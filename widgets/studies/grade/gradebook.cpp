// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/gradebook.h"

#include "core/fast/machinethreads.h"
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradereports.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

/// None where grading was cancelled, or memory ran out.
using Grading = std::optional<Result<std::optional<GradeReport>>>;

GradingOrder orderOf(const QString &submissions, const QString &results)
{
    return {submissions, results, QCoreApplication::applicationVersion(), threadsOfMachine()};
}

} // namespace

Gradebook::Gradebook(QObject *parent)
    : QObject(parent)
{
    m_writing.setMaxThreadCount(1);
}

std::size_t Gradebook::clusterOf(std::size_t submission) const { return m_clusterOf[submission]; }

void Gradebook::open(const QString &results)
{
    m_job.setTitle(tr("Reading grades"));
    m_job.start(
        [results](const ProgressListener &) -> std::optional<Result<GradeReport>> {
            if (!QFileInfo::exists(assignmentFileOf(results)))
                return InputError{results, u"holds no results"_s,
                                  u"a folder that grading wrote; submissions are "
                                  "graded by “Grade a folder…”"_s};
            return readGrades(results);
        },
        [this, results](const std::optional<Result<GradeReport>> &report) {
            if (!report)
                emit complaint(tr("The grades do not fit into memory."));
            else if (!*report)
                emit complaint(tr("No grades: %1").arg(report->error().message()));
            else
                take(results, **report);
        });
}

void Gradebook::grade(const QString &submissions, const QString &assignmentFile,
                      const QString &results, std::optional<Leeway> leeway)
{
    grade(orderOf(submissions, results), leeway,
          [assignmentFile] { return readAssignmentFile(assignmentFile); });
}

void Gradebook::gradeByScene(const QString &submissions, const Scene &scene, const QString &name,
                             const QString &results, std::optional<Leeway> leeway)
{
    grade(orderOf(submissions, results), leeway,
          [scene, name] { return assignmentOf(scene, name); });
}

void Gradebook::grade(const GradingOrder &order, std::optional<Leeway> leeway,
                      const std::function<Result<Assignment>()> &readAssignment)
{
    m_job.setTitle(tr("Grading"));
    m_job.start(
        [order, readAssignment, leeway](const ProgressListener &listener) -> Grading {
            Result<Assignment> assignment = readAssignment();
            if (!assignment)
                return assignment.error();
            assignment->margin.leeway = leeway.value_or(assignment->margin.leeway);
            return gradeFolder(order, *assignment, listener);
        },
        [this, results = order.results](const Grading &grading) {
            if (!grading)
                emit complaint(tr("The grading does not fit into memory."));
            else if (!*grading)
                emit complaint(tr("Nothing is graded: %1").arg(grading->error().message()));
            else if (**grading)
                take(results, ***grading);
            else
                emit notice(tr("Other runs are still grading into %1; the last one to finish "
                               "writes the reports.")
                                .arg(results));
        });
}

void Gradebook::writeReports()
{
    using Outcome = std::optional<InputError>;
    emit settling();
    m_job.setTitle(tr("Writing reports"));
    m_job.start(
        [results = m_results, report = m_report](const ProgressListener &) -> Outcome {
            return pixelplumb::writeReports(results, report);
        },
        [this](const Outcome &error) {
            if (error)
                emit complaint(tr("The reports were not written: %1").arg(error->message()));
            else
                emit notice(tr("The reports with your comments are written to %1.").arg(m_results));
        });
}

void Gradebook::cancel()
{
    if (!m_job.isRunning())
        return;
    m_job.cancel();
    emit notice(tr("Cancelled. What is graded stays, and the next run continues "
                   "from there."));
}

void Gradebook::setComment(std::span<const std::size_t> submissions, const QString &comment)
{
    bool isOther = false;
    for (const std::size_t place : submissions) {
        QString &said = m_report.submissions[place].review.comment;
        isOther = isOther || said != comment;
        said = comment;
    }
    if (isOther)
        saveReviews();
}

void Gradebook::setPoints(std::size_t submission, const std::optional<double> &points,
                          const QString &reason)
{
    GradeReview &review = m_report.submissions[submission].review;
    const auto said = points ? std::optional(reason) : std::nullopt;
    if (review.points == points && review.reason == said)
        return;
    review.points = points;
    review.reason = said;
    saveReviews();
}

void Gradebook::setAccepted(std::size_t submission, bool accepted)
{
    bool &said = m_report.submissions[submission].review.isAccepted;
    if (said == accepted)
        return;
    said = accepted;
    saveReviews();
}

void Gradebook::take(const QString &results, GradeReport report)
{
    emit settling();
    // Reviews made during the grading are newer than those that were read.
    for (GradedSubmission &submission : report.submissions) {
        const auto before
            = std::ranges::find(m_report.submissions, submission.id, &GradedSubmission::id);
        if (results == m_results && before != m_report.submissions.end())
            submission.review = before->review;
    }
    m_results = results;
    m_report = std::move(report);
    m_clusters = clustersOf(m_report);
    m_clusterOf.assign(m_report.submissions.size(), 0);
    for (std::size_t cluster = 0; cluster < m_clusters.size(); ++cluster) {
        for (const std::size_t place : m_clusters[cluster].submissions)
            m_clusterOf[place] = cluster;
    }
    emit opened();
}

void Gradebook::saveReviews()
{
    m_writing.start([this, results = m_results, report = m_report] {
        if (const auto error = writeReviews(results, report))
            emit complaint(tr("Your review is not saved: %1").arg(error->message()));
    });
    emit reviewed();
}

} // namespace pixelplumb
