// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/studies/diagnosisview.h"

#include <QObject>

class QUndoCommand;

namespace pixelplumb {

class SceneDocument;
class StudentPicture;

/// Puts a scene with defects in the document's place, as one edit, and takes it away again. The
/// student's picture is held to the right scene all the while.
class DefectStepper : public QObject {
    Q_OBJECT

public:
    DefectStepper(SceneDocument *document, StudentPicture *student, QObject *parent);

    /// Whether the document holds such a scene, maybe with edits after it.
    bool canLeave() const;

public slots:
    void open(const pixelplumb::DefectOpening &opening);
    void leave(); ///< undoes it, with the edits after it

signals:
    void opened(std::size_t position); ///< where to stand in the scene's run
    void leavingChanged(bool possible);

private:
    SceneDocument *m_document;
    StudentPicture *m_student;
    int m_index = 0; ///< of the edit on the undo stack
    const QUndoCommand *m_edit = nullptr; ///< null where there is none
};

} // namespace pixelplumb
