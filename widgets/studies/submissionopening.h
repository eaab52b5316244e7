// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QObject>
#include <QPoint>

#include <optional>

namespace pixelplumb {

class Playhead;
class SceneDocument;
class SceneFiles;
class StudentPicture;

/// A graded picture, and the scene that was to be drawn.
struct GradedPicture {
    Scene scene;
    QString results; ///< the folder in which it is
    QString file; ///< in that; empty: there is none
    QString name; ///< "ada · shallow"
    QString fault; ///< why there is none; empty where there is

    bool operator==(const GradedPicture &) const = default;
};

/// Opens a graded picture beside what was expected, at the first pixel that differs.
class SubmissionOpening : public QObject {
    Q_OBJECT

public:
    SubmissionOpening(const SceneDocument *document, SceneFiles *files, StudentPicture *student,
                      Playhead *playhead, QObject *parent);

public slots:
    void open(const pixelplumb::GradedPicture &picture);
    void close(); ///< what was opened, where it is still there

signals:
    void pixelReached(const QPoint &pixel);
    void lost(); ///< it is not on show: the scene in hand was kept, or another picture has come

private:
    void arrive();
    void lose();

    const SceneDocument *m_document;
    SceneFiles *m_files;
    StudentPicture *m_student;
    Playhead *m_playhead;
    std::optional<GradedPicture> m_open;
    QString m_awaited; ///< the picture whose judgement is; empty: none
};

} // namespace pixelplumb
