// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

class ElidedLabel;
class Job;
class Playhead;
class StudentPicture;

/// The status bar's fields: the pixel under the mouse or picked, the current column and step, the
/// rules, and the verdict on the finished picture (objectName "statusFigures"), which is a
/// student's picture's while one is judged. Each is as wide as the widest text that it will show,
/// so that nothing moves while stepping.
class StatusFields : public QWidget {
    Q_OBJECT

public:
    StatusFields(const Playhead *playhead, const StudentPicture *student,
                 QWidget *parent = nullptr);

public slots:
    /// Shows the pixel under the mouse; without one, the picked pixel.
    void setHovered(std::optional<QPoint> pixel);

private:
    QLabel *addField(const QString &name);
    void addLine();
    void takeTrace();
    void refresh();
    QString pixelText() const;
    void tellVerdict();

    const Playhead *m_playhead;
    const StudentPicture *m_student;
    QBoxLayout *m_row;
    QLabel *m_pixel;
    QLabel *m_column;
    QLabel *m_step;
    QLabel *m_settings;
    ElidedLabel *m_verdict;
    std::optional<QPoint> m_hovered;
};

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
