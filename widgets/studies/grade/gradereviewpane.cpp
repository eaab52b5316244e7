// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/gradereviewpane.h"

#include "widgets/look/parts.h"
#include "widgets/studies/grade/gradebook.h"
#include "widgets/studies/grade/openings.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

GradeReviewPane::GradeReviewPane(Gradebook *book, QWidget *parent)
    : QWidget(parent)
    , m_book(book)
{
    auto *column = withParts(new QVBoxLayout(this), {}, 4, 0);
    m_scene
        = explained(new QComboBox(this), "gradingScene", tr("The scene whose picture is shown"));
    m_scene->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_scene->setMinimumContentsLength(4);
    m_causes = explained(new QLabel(this), "gradingCauses",
                         tr("What explains the pictures, for you, not for the student"));
    m_causes->setFont(bold(m_causes->font()));
    m_sentences = explained(new QLabel(this), "gradingSentences", tr("What the student is told"));
    m_done = explained(new QLabel(this), "gradingDone", tr("What was done, for you"));
    for (QLabel *each : {m_causes, m_sentences, m_done}) {
        each->setWordWrap(true);
        each->setAlignment(Qt::AlignTop);
        each->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    m_comment = explained(new QPlainTextEdit(this), "gradingComment",
                          tr("Your comment, for the student; it is saved as you leave the field"));
    m_comment->setPlaceholderText(tr("comment (C); Escape: back to the table"));
    m_comment->setTabChangesFocus(true);
    const int line = fontMetrics().lineSpacing();
    m_comment->setMinimumHeight(3 * line);
    QScrollArea *told = columnScroll(this); // texts of a fault or of many scenes are long
    told->setFocusPolicy(Qt::NoFocus);
    told->setMinimumHeight(2 * line);
    auto *page = new QWidget(told);
    withParts(new QVBoxLayout(page), {m_causes, m_sentences, {m_done, 1}}, 4, 0);
    told->setWidget(page);
    m_comment->installEventFilter(this);
    m_accept = namedButton("gradingAccept", tr("Accept (A)"),
                           tr("This grade is reviewed and goes out as it is (A)"), this);
    m_accept->setCheckable(true);
    m_forCluster = namedButton("gradingCommentCluster", tr("Copy to all with this bug"),
                               tr("Give every submission of the same cause this comment"), this);
    m_points = named(new QLineEdit(this), "gradingPoints",
                     tr("Points that replace those of the checks; leave it empty to keep "
                        "theirs"));
    m_points->setMaximumWidth(fontMetrics().horizontalAdvance(u"0000.00"_s) + 16);
    m_points->setValidator(new QDoubleValidator(0, largestPoints, 2, m_points));
    m_reason = named(new QLineEdit(this), "gradingReason",
                     tr("Your reason for changing the points, for the student; without a "
                        "reason they do not change"));
    m_reason->setPlaceholderText(tr("why these points (needed)"));
    for (QLineEdit *each : {m_points, m_reason}) {
        each->installEventFilter(this);
        connect(each, &QLineEdit::editingFinished, this, &GradeReviewPane::savePoints);
    }
    connect(m_points, &QLineEdit::returnPressed, m_reason, qOverload<>(&QWidget::setFocus));
    auto *row = new QHBoxLayout; // a single row: a low window's lines are for the texts
    row->setSpacing(4);
    row->addWidget(m_scene, 1);
    row->addWidget(m_accept);
    row->addWidget(m_forCluster);
    column->addLayout(row);
    column->addWidget(told, 2);
    column->addLayout(
        withParts(new QHBoxLayout, {new QLabel(tr("Points"), this), m_points, {m_reason, 1}}, 4));
    column->addWidget(m_comment, 1);
    connect(m_scene, &QComboBox::activated, this, &GradeReviewPane::sceneChosen);
    connect(m_accept, &QToolButton::clicked, this, &GradeReviewPane::toggleAccepted);
    connect(m_forCluster, &QToolButton::clicked, this, &GradeReviewPane::commentCluster);
    connect(book, &Gradebook::settling, this, &GradeReviewPane::saveComment);
    connect(book, &Gradebook::settling, this, &GradeReviewPane::savePoints);
    connect(book, &Gradebook::opened, this, &GradeReviewPane::showReport);
    connect(book, &Gradebook::reviewed, this, &GradeReviewPane::showReview);
    setSubmission(std::nullopt);
}

GradeReviewPane::~GradeReviewPane()
{
    saveComment();
    savePoints();
}

bool GradeReviewPane::lacksReason() const
{
    return !m_points->text().isEmpty() && m_reason->text().trimmed().isEmpty();
}

void GradeReviewPane::setSubmission(const std::optional<std::size_t> &place)
{
    saveComment();
    savePoints();
    if (m_shown && lacksReason()) {
        m_withoutReason[*m_shown] = m_points->text();
        emit m_book->complaint(
            tr("%1 keeps the points of the checks: %2 were typed without a reason.")
                .arg(m_book->report().submissions[*m_shown].name, m_points->text()));
    }
    m_shown = place;
    for (QWidget *each : std::initializer_list<QWidget *>{m_scene, m_comment, m_points, m_reason,
                                                          m_accept, m_forCluster})
        each->setEnabled(place.has_value());
    m_comment->clear();
    m_points->clear();
    m_reason->clear();
    m_points->setPlaceholderText({});
    if (place) {
        const GradedSubmission &submission = m_book->report().submissions[*place];
        m_points->setPlaceholderText(locale().toString(submission.pointsOfChecks()));
        const auto typed = m_withoutReason.find(*place);
        if (typed != m_withoutReason.end())
            m_points->setText(typed->second);
        else if (submission.review.points)
            m_points->setText(locale().toString(*submission.review.points));
        m_reason->setText(submission.review.reason.value_or(QString()));
        m_comment->setPlainText(submission.review.comment);
        const auto first = std::ranges::find_if(submission.scenes, [](const GradedScene &scene) {
            return scene.firstDifference || !scene.fault.isEmpty();
        });
        m_scene->setCurrentIndex(
            first == submission.scenes.end() ? 0 : int(first - submission.scenes.begin()));
    }
    showReview();
}

void GradeReviewPane::beginComment() { m_comment->setFocus(); }

std::optional<GradedPicture> GradeReviewPane::picture() const
{
    const int chosen = m_scene->currentIndex();
    if (!m_shown || chosen < 0)
        return std::nullopt;
    const GradedSubmission &submission = m_book->report().submissions[*m_shown];
    const AssignedScene &assigned = m_book->report().assignment.scenes[std::size_t(chosen)];
    const GradedScene &graded = submission.scenes[std::size_t(chosen)];
    const auto convention = submission.convention.value_or(FrameConvention::AsAsked);
    return GradedPicture{sceneIn(assigned.scene, convention),
                         m_book->results(),
                         graded.picture,
                         u"%1 · %2"_s.arg(submission.name, assigned.name),
                         graded.fault,
                         m_book->report().assignment.margin};
}

void GradeReviewPane::toggleAccepted()
{
    saveComment();
    if (m_shown)
        m_book->setAccepted(*m_shown, !m_book->report().submissions[*m_shown].review.isAccepted);
}

void GradeReviewPane::saveComment()
{
    if (m_shown)
        m_book->setComment(std::array{*m_shown}, m_comment->toPlainText().trimmed());
}

/// Points without a reason are not taken yet.
void GradeReviewPane::savePoints()
{
    bool isNumber = false;
    const double points = locale().toDouble(m_points->text(), &isNumber);
    if (!m_shown || lacksReason() || (!m_points->text().isEmpty() && !isNumber))
        return;
    m_withoutReason.erase(*m_shown);
    m_book->setPoints(*m_shown, isNumber ? std::optional(points) : std::nullopt,
                      m_reason->text().trimmed());
}

void GradeReviewPane::commentCluster()
{
    if (m_shown)
        m_book->setComment(m_book->clusters()[m_book->clusterOf(*m_shown)].submissions,
                           m_comment->toPlainText().trimmed());
}

void GradeReviewPane::showReport()
{
    m_shown.reset(); // it belonged to another report, and is saved
    m_withoutReason.clear();
    m_scene->clear();
    for (const AssignedScene &scene : m_book->report().assignment.scenes)
        m_scene->addItem(scene.name);
    setSubmission(std::nullopt);
}

void GradeReviewPane::showReview()
{
    const GradeReport &report = m_book->report();
    const GradedSubmission *submission = m_shown ? &report.submissions[*m_shown] : nullptr;
    m_accept->setChecked(submission && submission->review.isAccepted);
    m_sentences->clear();
    showCauses();
    if (!submission)
        return;
    GradedSubmission told = *submission;
    told.review.comment.clear(); // shown in the field below
    m_sentences->setText(sentencesFor(told, report.assignment.hint).join(u'\n'));
}

/// A submission that lost nothing needs no explanation.
void GradeReviewPane::showCauses()
{
    const GradedSubmission *submission
        = m_shown ? &m_book->report().submissions[*m_shown] : nullptr;
    const bool hasCause = submission
        && (submission->verdict != GradeVerdict::Right || !submission->lostInvariants().isEmpty());
    m_causes->setVisible(hasCause);
    m_causes->setText(hasCause ? m_book->clusters()[m_book->clusterOf(*m_shown)].title : QString());
    const bool isExplained
        = hasCause && submission->verdict == GradeVerdict::Wrong && submission->isExplained();
    m_done->setText(isExplained ? submission->candidates.front().forAssistant.join(u' ')
                                : QString());
}

bool GradeReviewPane::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_comment && event->type() == QEvent::FocusOut)
        saveComment();
    if (event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape) {
        emit left();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace pixelplumb
