// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QWidget>

class QLabel;
class QProgressBar;

namespace pixelplumb {

class Job;

/// The progress of a background job, with a button that cancels it; hidden when there is none.
class JobBar : public QWidget {
    Q_OBJECT

public:
    /// Object names and accessible names of the bar and the button. No name, no button.
    struct Names {
        QString bar;
        QString barInWords;
        QString cancel;
        QString cancelInWords;
    };

    JobBar(const Job *job, const Names &names, QWidget *parent = nullptr);

signals:
    void cancelRequested();

private:
    void begin(const QString &title);
    void tell(const JobProgress &progress);

    QLabel *m_title;
    QProgressBar *m_bar;
};

} // namespace pixelplumb
