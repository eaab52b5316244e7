// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/margin.h"
#include "core/scene/scene.h"
#include "widgets/studies/grade/diagnosisview.h"

#include <QtGui>

#include <optional>

namespace pixelplumb {

class Playhead;
class SceneDocument;
class SceneFiles;
class StudentPicture;
struct TracedScene;

/// Opens a scene that is in no file and, once it is traced, moves to a pixel that differs from the
/// truth.
class DifferenceOpening : public QObject {
    Q_OBJECT

public:
    DifferenceOpening(SceneFiles *files, Playhead *playhead, QObject *parent);

public slots:
    /// Moves to the first pixel that differs.
    void open(const pixelplumb::Scene &scene);
    /// Moves to this pixel. False when the person keeps the current scene.
    bool openAt(const pixelplumb::Scene &scene, const QPoint &pixel);

signals:
    void pixelReached(const QPoint &pixel); ///< the playhead is there

private:
    void arrive();
    void standAt(const QPoint &pixel, const TracedScene &traced);
    void goToFirstDifference(const TracedScene &traced);

    SceneFiles *m_files;
    Playhead *m_playhead;
    std::optional<Scene> m_awaited; ///< being traced
    std::optional<QPoint> m_pixel; ///< to move to; none: the first difference
};

/// A graded picture, and the scene that should have been drawn.
struct GradedPicture {
    Scene scene;
    QString results; ///< the folder of the picture
    QString file; ///< in that folder; empty: there is no picture
    QString name; ///< "ada · shallow"
    QString fault; ///< why there is no picture; empty where there is one
    Margin margin = {}; ///< by which it was graded

    bool operator==(const GradedPicture &) const = default;
};

/// Opens a graded picture beside the expected one, at the first pixel that differs.
class SubmissionOpening : public QObject {
    Q_OBJECT

public:
    SubmissionOpening(const SceneDocument *document, SceneFiles *files, StudentPicture *student,
                      Playhead *playhead, QObject *parent);

public slots:
    void open(const pixelplumb::GradedPicture &picture);
    void close(); ///< removes what was opened, if still there

signals:
    void arrived(); ///< the picture is judged
    void pixelReached(const QPoint &pixel);
    void lost(); ///< it is not shown: the old scene was kept, or another picture replaced it

private:
    void arrive();
    void lose();

    const SceneDocument *m_document;
    SceneFiles *m_files;
    StudentPicture *m_student;
    Playhead *m_playhead;
    std::optional<GradedPicture> m_open;
    QString m_awaited; ///< the picture whose judgement is awaited; empty: none
};

/// Replaces the document's scene by one with defects, as one edit, and undoes that again. Meanwhile
/// the student's picture is judged against the right scene.
class DefectStepper : public QObject {
    Q_OBJECT

public:
    DefectStepper(SceneDocument *document, StudentPicture *student, QObject *parent);

    /// Whether the document holds such a scene, perhaps edited since.
    bool canLeave() const;

public slots:
    void open(const pixelplumb::DefectOpening &opening);
    void leave(); ///< undoes it and the edits after it

signals:
    void opened(std::size_t position); ///< where to put the playhead in the scene's run
    void leavingChanged(bool possible);

private:
    SceneDocument *m_document;
    StudentPicture *m_student;
    int m_index = 0; ///< the edit's index on the undo stack
    const QUndoCommand *m_edit = nullptr; ///< null where there is none
};

} // namespace pixelplumb
