// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/openings.h"

#include "widgets/files/scenefiles.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"

namespace pixelplumb {

DifferenceOpening::DifferenceOpening(SceneFiles *files, Playhead *playhead, QObject *parent)
    : QObject(parent)
    , m_files(files)
    , m_playhead(playhead)
{
    connect(playhead, &Playhead::tracedChanged, this, &DifferenceOpening::arrive);
}

void DifferenceOpening::open(const Scene &scene)
{
    m_pixel.reset();
    m_awaited = scene;
    if (!m_files->showScene(scene))
        m_awaited.reset();
}

bool DifferenceOpening::openAt(const Scene &scene, const QPoint &pixel)
{
    m_pixel = pixel;
    m_awaited = scene;
    const bool isShown = m_files->showScene(scene);
    if (!isShown)
        m_awaited.reset();
    return isShown;
}

void DifferenceOpening::arrive()
{
    const TracedScene *traced = m_playhead->traced();
    if (!m_awaited || !traced || traced->scene != *m_awaited)
        return;
    m_awaited.reset();
    if (!m_pixel)
        return goToFirstDifference(*traced);
    standAt(*m_pixel, *traced);
}

/// Stops the playhead where the pixel's fate is decided: at the step that writes it, or, for a
/// missing one, at the step that rejects it or ends its column or row.
void DifferenceOpening::standAt(const QPoint &pixel, const TracedScene &traced)
{
    m_playhead->seek(traced.decidedAt(pixel.x(), pixel.y()));
    m_playhead->pick(pixel);
    emit pixelReached(pixel);
}

void DifferenceOpening::goToFirstDifference(const TracedScene &traced)
{
    if (const auto wrong = traced.firstWrongPixel())
        return standAt(QPoint(int(wrong->x), int(wrong->y)), traced);
    m_playhead->seek(m_playhead->end());
    emit m_playhead->message(tr("Drawn to the end: every pixel is as in the truth."));
}

SubmissionOpening::SubmissionOpening(const SceneDocument *document, SceneFiles *files,
                                     StudentPicture *student, Playhead *playhead, QObject *parent)
    : QObject(parent)
    , m_document(document)
    , m_files(files)
    , m_student(student)
    , m_playhead(playhead)
{
    connect(student, &StudentPicture::judged, this, &SubmissionOpening::arrive);
    connect(student, &StudentPicture::taken, this, [this] {
        if (m_open && m_student->name() != m_open->name)
            lose();
    });
}

void SubmissionOpening::open(const GradedPicture &picture)
{
    const bool isOpen = m_open == picture && m_student->name() == picture.name
        && m_document->scene() == picture.scene;
    if (isOpen) {
        m_awaited = picture.name;
        return arrive();
    }
    m_awaited.clear();
    m_open.reset();
    m_student->remove(); // the old one belongs to another scene or another student
    if (m_document->scene() != picture.scene && !m_files->showScene(picture.scene))
        return lose();
    m_open = picture;
    m_student->setMargin(picture.margin);
    const bool isThere = !picture.file.isEmpty();
    m_student->expect(picture.name,
                      isThere ? tr("Being opened.") : tr("No picture: %1.").arg(picture.fault));
    if (!isThere)
        return;
    m_student->openResult(picture.results, picture.file, picture.name);
    m_awaited = picture.name;
}

void SubmissionOpening::close()
{
    if (m_open && m_student->name() == m_open->name)
        m_student->remove();
    m_awaited.clear();
    m_open.reset();
}

void SubmissionOpening::lose()
{
    m_awaited.clear();
    m_open.reset();
    emit lost();
}

void SubmissionOpening::arrive()
{
    const auto &judgement = m_student->judgement();
    if (m_awaited.isEmpty() || !judgement || m_student->name() != m_awaited)
        return;
    m_awaited.clear();
    m_playhead->seek(m_playhead->end());
    emit arrived();
    const std::optional<QPoint> pixel = judgement->firstDifference();
    if (!pixel)
        return;
    m_playhead->pick(*pixel);
    emit pixelReached(*pixel);
}

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
