// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QStatusBar>

class QToolButton;

namespace pixelplumb {

class Job;

/// The pointer's and the playhead's place, and the background jobs.
class WindowStatusBar : public QStatusBar {
    Q_OBJECT

public:
    explicit WindowStatusBar(const WindowParts &parts, QWidget *window = nullptr);

public slots:
    void tellBriefly(const QString &text);

private:
    /// Object names and accessible names of a job's bar and its button. No name, no button.
    struct JobNames {
        QString bar;
        QString barInWords;
        QString cancel;
        QString cancelInWords;
    };

    /// Adds the progress of a job, hidden when there is none; returns the button that cancels it.
    QToolButton *addJob(const Job &job, const JobNames &names);
    void addFields(const WindowParts &parts);
};

} // namespace pixelplumb
