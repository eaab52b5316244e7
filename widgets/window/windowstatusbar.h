// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/jobbar.h"
#include "widgets/window/windowparts.h"

#include <QStatusBar>

namespace pixelplumb {

/// Where the pointer and time are, the jobs beside the window, and by which eyes it is seen if not
/// by ordinary ones.
class WindowStatusBar : public QStatusBar {
    Q_OBJECT

public:
    explicit WindowStatusBar(const WindowParts &parts, QWidget *window = nullptr);

public slots:
    void tellBriefly(const QString &text);

private:
    JobBar *addJob(const Job &job, const JobBar::Names &names);
    void addFields(const WindowParts &parts);
    void addVision(ColourVisionSwitch *vision);
};

} // namespace pixelplumb
