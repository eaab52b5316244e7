// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/defectstepper.h"

#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"

namespace pixelplumb {

DefectStepper::DefectStepper(SceneDocument *document, StudentPicture *student, QObject *parent)
    : QObject(parent)
    , m_document(document)
    , m_student(student)
{
    connect(document->undoStack(), &QUndoStack::indexChanged, this,
            [this] { emit leavingChanged(canLeave()); });
    connect(document, &SceneDocument::opened, this, [this] {
        m_edit = nullptr;
        emit leavingChanged(false);
    });
}

bool DefectStepper::canLeave() const
{
    const QUndoStack *stack = m_document->undoStack();
    return m_edit && stack->index() > m_index && stack->command(m_index) == m_edit;
}

void DefectStepper::open(const DefectOpening &opening)
{
    leave();
    const QUndoStack *stack = m_document->undoStack();
    m_index = stack->index();
    m_student->setRightOf(opening.defective, opening.right);
    m_document->setScene(opening.defective, tr("defect %1").arg(opening.title));
    m_edit = stack->index() > m_index ? stack->command(m_index) : nullptr;
    emit leavingChanged(canLeave());
    emit opened(opening.position);
}

void DefectStepper::leave()
{
    if (canLeave())
        m_document->undoStack()->setIndex(m_index);
}

} // namespace pixelplumb
