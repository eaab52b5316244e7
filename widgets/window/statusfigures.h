// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/elidedlabel.h"
#include "widgets/model/job.h"

namespace pixelplumb {

class Playhead;
class StudentPicture;

/// The errors of the current method and arithmetic on this scene, and in the tool tip their costs
/// (objectName "statusFigures"). Measured in a worker thread, and only while visible. While a
/// student's picture is judged, its verdict is shown instead: only one verdict at a time.
class StatusFigures : public ElidedLabel {
    Q_OBJECT

public:
    StatusFigures(const Playhead *playhead, const StudentPicture *student,
                  QWidget *parent = nullptr);

    bool isMeasuring() const { return m_job.isRunning(); }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void measure();
    void tell(const QString &figures, const QString &details);
    void showVerdict();

    const Playhead *m_playhead;
    const StudentPicture *m_student;
    QString m_figures; ///< of the method
    QString m_details;
    bool m_isStale = true;
    Job m_job;
};

} // namespace pixelplumb
