// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/diagnosisview.h"

#include "core/grade/undecidable.h"
#include "core/number/failure.h"
#include "widgets/look/elidingbox.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/diagnosistext.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>

namespace pixelplumb {

namespace {

QPushButton *pushButton(const char *name, const QString &text, const QString &tip, QWidget *parent)
{
    auto *result = new QPushButton(text, parent);
    result->setObjectName(QLatin1String(name));
    result->setToolTip(tip);
    result->setAutoDefault(false);
    return result;
}

} // namespace

DiagnosisView::DiagnosisView(const StudentPicture *student, QWidget *parent)
    : QWidget(parent)
    , m_student(student)
{
    setObjectName(QStringLiteral("diagnosis"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    addControls(layout);
    addResults(layout);
    m_job.setTitle(tr("Naming the bug"));
    connect(&m_job, &Job::started, this, &DiagnosisView::updateButtons);
    connect(&m_job, &Job::ended, this, &DiagnosisView::updateButtons);
    connect(&m_job, &Job::progressChanged, this, [this](const JobProgress &progress) {
        m_progress->setRange(0, int(progress.total));
        m_progress->setValue(int(progress.done));
    });
    connect(student, &StudentPicture::taken, this, &DiagnosisView::forget);
    connect(student, &StudentPicture::judged, this, &DiagnosisView::followStudent);
    forget();
}

DiagnosisView::~DiagnosisView() = default;

void DiagnosisView::addControls(QBoxLayout *layout)
{
    m_start
        = pushButton("nameTheBug", tr("Name the &bug"),
                     tr("Find the known defects, one or two, that draw this very picture"), this);
    m_cancel = pushButton("diagnosisCancel", tr("Cancel"), tr("Stop looking for defects"), this);
    m_progress = new QProgressBar(this);
    m_progress->setObjectName(QStringLiteral("diagnosisProgress"));
    m_progress->setAccessibleName(tr("Sets of defects that are tried"));
    m_progress->setTextVisible(false);
    m_audience = new ElidingBox(this);
    m_audience->setMinimumContentsLength(5);
    m_audience->setObjectName(QStringLiteral("diagnosisAudience"));
    m_audience->setAccessibleName(tr("Whose words"));
    m_audience->setToolTip(tr("For whom. Student: where to look. Assistant: what was done."));
    m_audience->addItem(tr("student"));
    m_audience->addItem(tr("assistant"));
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_start);
    row->addWidget(m_progress, 1);
    row->addWidget(m_cancel);
    row->addWidget(m_audience);
    row->addStretch();
    layout->addLayout(row);
    connect(m_start, &QPushButton::clicked, this, &DiagnosisView::start);
    connect(m_cancel, &QPushButton::clicked, this, &DiagnosisView::cancel);
    connect(m_audience, &QComboBox::currentIndexChanged, this, &DiagnosisView::showCandidates);
}

void DiagnosisView::addResults(QBoxLayout *layout)
{
    const auto addLabel = [&](const char *name, const QString &inWords) {
        auto *label = new QLabel(this);
        label->setObjectName(QLatin1String(name));
        label->setAccessibleName(inWords);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        layout->addWidget(label);
        return label;
    };
    m_verdict = addLabel("diagnosisVerdict", tr("What the diagnosis says"));
    m_candidates = new QListWidget(this);
    m_candidates->setObjectName(QStringLiteral("diagnosisCandidates"));
    m_candidates->setAccessibleName(tr("Sets of defects"));
    m_candidates->setWordWrap(true);
    m_candidates->setMinimumHeight(56);
    m_candidates->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    layout->addWidget(m_candidates, 1);
    m_sentence = addLabel("diagnosisSentence", tr("What the chosen defects are"));
    m_open = pushButton(
        "diagnosisOpen", tr("Open in the stepper"),
        tr("Run the scene with these defects and go to the first step that differs from the right "
           "run; if no run can have them, show the right run at that step"),
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

std::optional<DiagnosisView::Named> DiagnosisView::named(const Submission &submission,
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
    m_progress->setRange(0, 0);
    m_job.start(
        [scene = m_judged, margin = m_margin, judgement](const ProgressListener &listener) {
            return named({*scene, judgement->found}, margin, listener);
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
        if (const auto &step = m_named->steps[std::size_t(row)])
            text += (text.isEmpty() ? QString() : QStringLiteral("\n"))
                + tr("First wrong number: step %1, %2: %3.")
                      .arg(step->step + 1)
                      .arg(step->heading, step->text);
    }
    m_sentence->setText(text);
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
    m_progress->setVisible(runs);
    m_cancel->setVisible(runs);
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
    return {m_judged, withDefects(*m_judged, candidate.defects), step ? step->step + 1 : 0,
            idsText(candidate)};
}

} // namespace pixelplumb
