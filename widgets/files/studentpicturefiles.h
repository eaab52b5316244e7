// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

class StudentPicture;

/// Brings a student's picture into the window: chosen, dropped or pasted.
class StudentPictureFiles : public QObject {
    Q_OBJECT

public:
    StudentPictureFiles(StudentPicture *student, QWidget *window);

    /// Whether the data may hold a picture: a file, an image, a raster.
    static bool accepts(const QMimeData &data);

public slots:
    void open();
    void take(const QMimeData &data);

private:
    StudentPicture *m_student;
    QWidget *m_window;
    QString m_folder; ///< of the picture chosen last
};

/// The single local file that is dragged over the window or copied, where it is a scene: JSON.
QString sceneFileOf(const QMimeData &data);
/// The single local folder that is dragged over the window.
QString folderOf(const QMimeData &data);

} // namespace pixelplumb
