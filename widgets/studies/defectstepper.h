// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/studies/diagnosisview.h"

#include <QObject>

class QUndoCommand;

namespace pixelplumb {

class SceneDocument;
class StudentPicture;

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
