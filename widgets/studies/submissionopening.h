// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QObject>
#include <QPoint>

namespace pixelplumb {

class Playhead;
class SceneDocument;
class SceneFiles;
class StudentPicture;

/// A graded picture, and the scene that was to be drawn.
struct GradedPicture {
    Scene scene;
    QString path; ///< empty: there is none
    QString name; ///< "ada · shallow"
    QString fault; ///< why there is none; empty where there is
};

/// Opens a graded picture beside what was expected, at the first pixel that differs.
class SubmissionOpening : public QObject {
    Q_OBJECT

public:
    SubmissionOpening(const SceneDocument *document, SceneFiles *files, StudentPicture *student,
                      Playhead *playhead, QObject *parent);

public slots:
    void open(const pixelplumb::GradedPicture &picture);

signals:
    void pixelReached(const QPoint &pixel);

private:
    void arrive();

    const SceneDocument *m_document;
    SceneFiles *m_files;
    StudentPicture *m_student;
    Playhead *m_playhead;
    QString m_awaited; ///< the picture whose judgement is; empty: none
};

} // namespace pixelplumb
