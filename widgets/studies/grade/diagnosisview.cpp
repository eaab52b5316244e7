// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/diagnosisview.h"

#include "core/grade/diagnose/undecidable.h"
#include "core/number/failure.h"
#include "widgets/look/corewords.h"
#include "widgets/look/labels.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/studypanel.h"

namespace pixelplumb {

DiagnosisView::DiagnosisView(const StudentPicture *student, QWidget *parent)
    : QWidget(parent)
    , m_student(student)
{
    setObjectName(u"diagnosis"_s);
    auto *layout = withParts(new QVBoxLayout(this), {}, 4, 0);
    addControls(layout);
    addResults(layout);
    m_job.setTitle(tr("Naming the bug"));
    connect(&m_job, &Job::started, this, &DiagnosisView::updateButtons);
    connect(&m_job, &Job::ended, this, &DiagnosisView::updateButtons);
    connect(student, &StudentPicture::taken, this, &DiagnosisView::forget);
    connect(student, &StudentPicture::judged, this, &DiagnosisView::followStudent);
    forget();
}

void DiagnosisView::addControls(QBoxLayout *layout)
{
    m_start
        = pushButton("nameTheBug", tr("Name the &bug"),
                     tr("Find the one or two known defects that draw exactly this picture"), this);
    auto *progress
        = new JobBar(m_job, u"diagnosis"_s, tr("Sets of defects that are tried"), 0, this);
    m_audience = new ElidingBox(this);
    m_audience->setMinimumContentsLength(5);
    named(m_audience, "diagnosisAudience", tr("Whose words"),
          tr("Who reads it. Student: where to look. Assistant: what the "
             "program does."));
    m_audience->addItem(tr("student"));
    m_audience->addItem(tr("assistant"));
    auto *row = withParts(new QHBoxLayout, {m_start, {progress, 1}, m_audience, Room()}, 4);
    layout->addLayout(row);
    connect(m_start, &QPushButton::clicked, this, &DiagnosisView::start);
    connect(progress, &JobBar::cancelled, this, &DiagnosisView::cancel);
    connect(m_audience, &QComboBox::currentIndexChanged, this, &DiagnosisView::showCandidates);
}

void DiagnosisView::addResults(QBoxLayout *layout)
{
    m_verdict = readingLabel("diagnosisVerdict", tr("What the diagnosis says"), this);
    layout->addWidget(m_verdict);
    m_candidates = named(new QListWidget(this), "diagnosisCandidates", tr("Sets of defects"));
    m_candidates->setWordWrap(true);
    m_candidates->setMinimumHeight(56);
    m_candidates->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    layout->addWidget(m_candidates, 1);
    m_sentence = readingLabel("diagnosisSentence", tr("What the chosen defects are"), this);
    m_sentence->setTextFormat(Qt::RichText);
    layout->addWidget(m_sentence);
    m_open = pushButton("diagnosisOpen", tr("Step through it"),
                        tr("Run the scene with these defects in Step, from the first step "
                           "that differs from the right run. If no run can have these "
                           "defects, show that step of the right run. Alt+Left: back"),
                        this);
    m_compare = pushButton("diagnosisCompare", tr("Compare"),
                           tr("The same, with the right run beside it in Compare"), this);
    m_leave
        = pushButton("diagnosisLeave", tr("Back"), tr("Back to the scene without defects"), this);
    auto *rows = new QGridLayout;
    rows->setSpacing(4);
    rows->addWidget(m_open, 0, 0, 1, 2);
    rows->addWidget(m_compare, 1, 0);
    rows->addWidget(m_leave, 1, 1);
    layout->addLayout(rows);
    connect(m_candidates, &QListWidget::currentRowChanged, this, &DiagnosisView::showChosen);
    connect(m_candidates, &QListWidget::itemActivated, this,
            [this] { emit openRequested(opening()); });
    connect(m_open, &QPushButton::clicked, this, [this] { emit openRequested(opening()); });
    connect(m_compare, &QPushButton::clicked, this, [this] { emit compareRequested(opening()); });
    connect(m_leave, &QPushButton::clicked, this, &DiagnosisView::leaveRequested);
}

std::optional<DiagnosisView::Named> DiagnosisView::diagnosed(const Submission &submission,
                                                             const Margin &margin,
                                                             const ProgressListener &listener)
{
    std::optional<Diagnosis> diagnosis = diagnose(std::span(&submission, 1), listener, margin);
    if (!diagnosis)
        return std::nullopt;
    Named found{std::move(*diagnosis), {}};
    // A name that explains next to nothing is dropped.
    std::erase_if(found.diagnosis.candidates, [&found](const DiagnosisCandidate &candidate) {
        return !isRelevant(candidate.distance, found.diagnosis.differing);
    });
    for (const DiagnosisCandidate &candidate : found.diagnosis.candidates) {
        auto &step = found.steps.emplace_back();
        failureOf([&] { step = partingStepOf(submission.scene, candidate.defects); });
    }
    return found;
}

void DiagnosisView::start()
{
    const auto judgement = m_student->judgement();
    if (!judgement)
        return;
    forget();
    m_scene = m_student->scene();
    m_margin = m_student->margin();
    m_judged = std::make_shared<const Scene>(judgedScene(*m_scene, m_margin));
    m_job.start(
        [scene = m_judged, margin = m_margin, judgement](const ProgressListener &listener) {
            return diagnosed({*scene, judgement->found}, margin, listener);
        },
        [this](const std::optional<Named> &found) { take(found); });
}

void DiagnosisView::cancel()
{
    m_job.cancel();
    m_scene.reset();
    m_verdict->setText(tr("Cancelled."));
}

void DiagnosisView::take(const std::optional<Named> &found)
{
    m_named = found;
    if (!found)
        return m_verdict->setText(tr("The diagnosis does not fit into memory."));
    m_verdict->setText(diagnosisText(found->diagnosis));
    showCandidates();
    emit answered();
}

QRect DiagnosisView::answer() const
{
    QRect result;
    const std::initializer_list<QWidget *> parts{m_verdict, m_candidates, m_sentence};
    for (const QWidget *part : parts) {
        if (part->isVisibleTo(this))
            result |= part->geometry();
    }
    return result;
}

void DiagnosisView::forget()
{
    m_job.cancel();
    m_scene.reset();
    m_named.reset();
    m_verdict->clear();
    showCandidates();
}

/// Forgets the findings when the scene or the leeway changes: they belong to one of each.
void DiagnosisView::followStudent()
{
    const bool isOfAnother = m_scene
        && (!m_student->isThere() || m_margin != m_student->margin()
            || (m_scene != m_student->scene() && *m_scene != *m_student->scene()));
    if (isOfAnother)
        forget();
    updateButtons();
}

DiagnosisView::Audience DiagnosisView::audience() const
{
    return Audience(m_audience->currentIndex());
}

QString DiagnosisView::titleOf(const DiagnosisCandidate &candidate) const
{
    return audience() == Audience::Assistant ? idsText(candidate)
                                             : sentencesText(candidate, &Defect::forStudent);
}

void DiagnosisView::showCandidates()
{
    const int chosen = std::max(0, m_candidates->currentRow());
    m_candidates->clear();
    if (m_named) {
        for (const DiagnosisCandidate &candidate : m_named->diagnosis.candidates)
            m_candidates->addItem(titleOf(candidate) + distanceText(candidate));
    }
    const bool isEmpty = m_candidates->count() == 0;
    m_candidates->setVisible(!isEmpty);
    m_verdict->setVisible(!m_verdict->text().isEmpty());
    if (!isEmpty)
        m_candidates->setCurrentRow(std::min(chosen, m_candidates->count() - 1));
    showChosen();
}

void DiagnosisView::showChosen()
{
    const int row = m_candidates->currentRow();
    QString text;
    if (m_named && row >= 0) {
        const DiagnosisCandidate &candidate = m_named->diagnosis.candidates[std::size_t(row)];
        if (audience() == Audience::Assistant)
            text = sentencesText(candidate, &Defect::forAssistant);
        if (const auto &step = m_named->steps[std::size_t(row)]) {
            QString place = step->heading; // within a sentence: "column 5, first half"
            place.replace(0, 1, place.left(1).toLower());
            text += (text.isEmpty() ? QString() : u"\n"_s)
                + tr("First wrong number: step %1, %2: %3.")
                      .arg(step->step + 1)
                      .arg(coreWord(place), step->text);
        }
    }
    m_sentence->setText(typesetHtml(text).replace(u'\n', u"<br>"_s));
    m_sentence->setVisible(!text.isEmpty());
    updateButtons();
}

void DiagnosisView::updateButtons()
{
    const bool runs = m_job.isRunning();
    const int row = m_candidates->currentRow();
    const bool canOpen = m_named && row >= 0
        && (m_named->steps[std::size_t(row)] || opening().defective != *m_judged);
    m_start->setEnabled(!runs && m_student->judgement());
    m_audience->setVisible(!runs);
    for (QPushButton *each : {m_open, m_compare, m_leave})
        each->setVisible(m_named && row >= 0);
    m_open->setEnabled(canOpen);
    m_compare->setEnabled(canOpen && opening().defective.settings != m_judged->settings);
}

void DiagnosisView::setLeaving(bool possible) { m_leave->setEnabled(possible); }

DefectOpening DiagnosisView::opening() const
{
    const auto row = std::size_t(m_candidates->currentRow());
    const DiagnosisCandidate &candidate = m_named->diagnosis.candidates[row];
    const auto &step = m_named->steps[row];
    return {m_judged, steppedWithDefects(*m_judged, candidate.defects), step ? step->step + 1 : 0,
            idsText(candidate)};
}

QString diagnosisText(const Diagnosis &diagnosis)
{
    if (diagnosis.verdict == DiagnosisVerdict::Right)
        return DiagnosisView::tr("Right: no pixel differs, so there is no bug to name.");
    const QString verdict = diagnosis.verdict == DiagnosisVerdict::Wrong
        ? DiagnosisView::tr("Wrong.")
        : DiagnosisView::tr(
            "Right within the leeway: every pixel that differs may do so in a right program.");
    if (diagnosis.failure)
        return verdict + u' '
            + DiagnosisView::tr("The search for defects ended in an error: %1.")
                  .arg(*diagnosis.failure);
    const QString near = diagnosis.sampled ? u' '
            + DiagnosisView::tr("Sets that only come near were looked for in %1 of %2 columns or "
                                "rows: a nearer one may be missing.")
                  .arg(diagnosis.sampled->spans)
                  .arg(diagnosis.sampled->of)
                                           : QString();
    if (diagnosis.candidates.empty())
        return diagnosis.verdict == DiagnosisVerdict::Wrong
            ? verdict + u' ' + DiagnosisView::tr("No known bug explains it.") + near
            : verdict;
    if (!diagnosis.isExplained())
        return verdict + near + u' '
            + DiagnosisView::tr("No known bug explains it; the nearest ones:");
    return verdict + u' '
        + (diagnosis.candidates.front().undecidable > 0
               ? DiagnosisView::tr("Known bugs produce this picture, except for pixels that "
                                   "rounding or an edge may "
                                   "decide:")
               : DiagnosisView::tr("%n sets of known bugs produce this picture:", nullptr,
                                   int(diagnosis.candidates.size())));
}

QString idsText(const DiagnosisCandidate &candidate)
{
    return candidate.ids().join(DiagnosisView::tr(" and "));
}

QString sentencesText(const DiagnosisCandidate &candidate, QString Defect::*words)
{
    return candidate.sentences(words).join(u' ');
}

QString distanceText(const DiagnosisCandidate &candidate)
{
    if (candidate.distance == 0 && candidate.undecidable == 0)
        return {};
    if (candidate.distance == 0)
        return DiagnosisView::tr(" · except for %n pixels that rounding or an edge may decide",
                                 nullptr, int(candidate.undecidable));
    return DiagnosisView::tr(" · %n pixels remain unexplained", nullptr, int(candidate.distance));
}

} // namespace pixelplumb
