// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradefolder.h"
#include "widgets/model/job.h"

#include <QtCore>

#include <functional>
#include <span>

namespace pixelplumb {

/// A folder of results that an assistant reviews: read, graded and reported in worker threads.
/// Reviews are written in a worker thread as soon as they are made, in order, and all of them
/// before the book is destroyed.
class Gradebook : public QObject {
    Q_OBJECT

public:
    explicit Gradebook(QObject *parent = nullptr);

    const QString &results() const { return m_results; } ///< empty before the first
    const GradeReport &report() const { return m_report; }
    const std::vector<GradeCluster> &clusters() const { return m_clusters; }
    /// The index of a submission's cluster.
    std::size_t clusterOf(std::size_t submission) const;
    const Job &job() const { return m_job; }

public slots:
    void open(const QString &results);
    /// Grades, continuing where an earlier run stopped; reviews stay. With a leeway, by that in
    /// place of the assignment's.
    void grade(const QString &submissions, const QString &assignmentFile, const QString &results,
               std::optional<pixelplumb::Leeway> leeway = {});
    /// Likewise by an assignment of this scene alone, which has that name.
    void gradeByScene(const QString &submissions, const Scene &scene, const QString &name,
                      const QString &results, std::optional<pixelplumb::Leeway> leeway);
    void writeReports(); ///< for Gradescope and others, with the comments
    void cancel();
    void setComment(std::span<const std::size_t> submissions, const QString &comment);
    /// In place of those of the checks; none: those.
    void setPoints(std::size_t submission, const std::optional<double> &points,
                   const QString &reason);
    void setAccepted(std::size_t submission, bool accepted);

signals:
    void settling(); ///< unsaved input must be handed over now
    void opened(); ///< another report
    void reviewed(); ///< the review of some submission changed
    void complaint(const QString &text);
    void notice(const QString &text);

private:
    void grade(const GradingOrder &order, std::optional<Leeway> leeway,
               const std::function<Result<Assignment>()> &readAssignment);
    void take(const QString &results, GradeReport report);
    void saveReviews();

    QString m_results;
    GradeReport m_report;
    std::vector<GradeCluster> m_clusters;
    std::vector<std::size_t> m_clusterOf; ///< by submission
    Job m_job;
    QThreadPool m_writing; ///< one thread: saves in order; its destructor waits for all
};

} // namespace pixelplumb
