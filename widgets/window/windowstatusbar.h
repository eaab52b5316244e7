// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/jobbar.h"
#include "widgets/window/windowparts.h"

#include <QStatusBar>

namespace pixelplumb {

/// The pointer's and the playhead's place, and the background jobs.
class WindowStatusBar : public QStatusBar {
    Q_OBJECT

public:
    explicit WindowStatusBar(const WindowParts &parts, QWidget *window = nullptr);

public slots:
    void tellBriefly(const QString &text);

private:
    JobBar *addJob(const Job &job, const JobBar::Names &names);
    void addFields(const WindowParts &parts);
};

} // namespace pixelplumb
