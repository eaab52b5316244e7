// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/elidedlabel.h"
#include "widgets/model/job.h"

namespace pixelplumb {

class Playhead;
class StudentPicture;

/// What the method and the arithmetic in hand get wrong of this scene, and in the tool tip what
/// they take (objectName "statusFigures"). Measured beside the GUI thread, and only while it is
/// seen. While a student's picture is judged the verdict on that stands here instead: one verdict
/// is told at a time.
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
