// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/gradefolder.h"
#include "widgets/model/job.h"

#include <QObject>
#include <QThreadPool>

#include <span>

namespace pixelplumb {

/// A folder of results in the hands of an assistant: read, graded and reported beside the GUI
/// thread. What the assistant says is written as soon as it is said, beside it too; what is said
/// last is written last, and before the book is gone.
class Gradebook : public QObject {
    Q_OBJECT

public:
    explicit Gradebook(QObject *parent = nullptr);

    const QString &results() const { return m_results; } ///< empty before the first
    const GradeReport &report() const { return m_report; }
    const std::vector<GradeCluster> &clusters() const { return m_clusters; }
    /// The place among the clusters of a submission.
    std::size_t clusterOf(std::size_t submission) const;
    const Job &job() const { return m_job; }

public slots:
    void open(const QString &results);
    /// Goes on where an earlier run stopped; comments stay.
    void grade(const QString &submissions, const QString &assignmentFile, const QString &results);
    void writeReports(); ///< for Gradescope and others, with the comments
    void cancel();
    void setComment(std::span<const std::size_t> submissions, const QString &comment);
    void setAccepted(std::size_t submission, bool accepted);

signals:
    void settling(); ///< what is being said must be told now
    void opened(); ///< another report
    void reviewed(); ///< what is said of some submission is another
    void complaint(const QString &text);
    void notice(const QString &text);

private:
    void take(const QString &results, GradeReport report);
    void saveReviews();

    QString m_results;
    GradeReport m_report;
    std::vector<GradeCluster> m_clusters;
    std::vector<std::size_t> m_clusterOf; ///< by submission
    Job m_job;
    QThreadPool m_writing; ///< of one thread: in the order of saving; waits for all at its end
};

} // namespace pixelplumb
