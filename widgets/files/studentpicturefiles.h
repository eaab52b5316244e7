// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMimeData;
class QWidget;

namespace pixelplumb {

class StudentPicture;

/// How a student's picture comes into the window: chosen, dropped or pasted.
class StudentPictureFiles : public QObject {
    Q_OBJECT

public:
    StudentPictureFiles(StudentPicture *student, QWidget *window);

    /// Whether it may hold one: a file, a picture, a raster.
    static bool accepts(const QMimeData &data);

public slots:
    void open();
    void take(const QMimeData &data);

private:
    StudentPicture *m_student;
    QWidget *m_window;
    QString m_folder; ///< of the last one that was chosen
};

/// The one local file of what is dragged over the window or copied, where that is a scene: JSON.
QString sceneFileOf(const QMimeData &data);
/// The one local folder of what is dragged over the window.
QString folderOf(const QMimeData &data);

} // namespace pixelplumb
