// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/job.h"

#include <QtWidgets>

namespace pixelplumb {

/// The progress of a job with a button to cancel it, while it runs: the parts are called
/// `name` + "Progress" and `name` + "Cancel".
class JobBar : public QWidget {
    Q_OBJECT

public:
    /// A progress bar no wider than `width`; 0: as wide as there is room.
    JobBar(const Job &job, const QString &name, const QString &inWords, int width, QWidget *parent);

signals:
    void cancelled(); ///< the button was pressed; the job's owner cancels it
};

/// A panel whose study runs beside the GUI thread: it begins when the panel is seen and what it
/// shows no longer holds. During a drag newer studies cancel older ones.
class StudyPanel : public QWidget {
    Q_OBJECT

public:
    StudyPanel(const char *name, const QString &inWords, QWidget *parent);

    bool isRunning() const { return m_job.isRunning(); }

protected:
    /// Begins anew, now or when the panel is seen: what is shown no longer holds.
    void restart();
    /// Starts the study, or says why there is none; false where it waits for a scene.
    virtual bool beginStudy() = 0;
    bool isStale() const { return m_isStale; }
    /// Says it in the summary and to assistive technology.
    void tell(const QString &text);

    Job m_job;
    QLabel *m_summary = nullptr;

private:
    void studyIfDue();

    bool m_isStale = true;
};

} // namespace pixelplumb
