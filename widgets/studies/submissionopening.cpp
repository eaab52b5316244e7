// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/submissionopening.h"

#include "widgets/files/scenefiles.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"

namespace pixelplumb {

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
    const std::optional<QPoint> pixel = judgement->firstDifference();
    if (!pixel)
        return;
    m_playhead->pick(*pixel);
    emit pixelReached(*pixel);
}

} // namespace pixelplumb
