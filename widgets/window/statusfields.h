// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QWidget>

#include <optional>

class QBoxLayout;
class QLabel;

namespace pixelplumb {

class ElidedLabel;
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

} // namespace pixelplumb
