// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/submissionpanel.h"

#include "widgets/look/labels.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/compare/comparelink.h"
#include "widgets/studies/grade/diagnosisview.h"
#include "widgets/studies/grade/leewaybox.h"
#include "widgets/studies/grade/submissionview.h"

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr int leastPicture = 72; ///< its height

} // namespace

SubmissionPanel::SubmissionPanel(StudentPicture *student, Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_student(student)
    , m_playhead(playhead)
    , m_link(new CompareLink(this))
{
    setObjectName(u"submission"_s);
    auto *area = named(columnScroll(this), "submissionArea", tr("Submission"));
    area->setFocusPolicy(Qt::NoFocus);
    withParts(new QVBoxLayout(this), {area}, -1, 0);
    m_content = new QWidget(area);
    area->setWidget(m_content);
    auto *layout = withParts(new QVBoxLayout(m_content), {}, 8, 8);
    addHead(layout);
    addTexts(layout);
    m_diagnosis = new DiagnosisView(student, m_content);
    layout->addWidget(m_diagnosis); // before the pictures, so that a small window shows it
    addPictures(layout);
    layout->addStretch();
    // In a small window the answer would lie below the visible part. Layout first, so that its
    // height is known.
    connect(m_diagnosis, &DiagnosisView::answered, area, [this, area] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        const QRect answer = m_diagnosis->answer().translated(m_diagnosis->pos());
        area->ensureVisible(0, answer.bottom(), 0, 4);
        area->ensureVisible(0, answer.top(), 0, 0);
    });
    onEvents(this, {QEvent::Resize}, [this] { fitPictures(); });
    onEvents(this, {QEvent::PaletteChange}, [this] { showJudgement(); });
    connect(student, &StudentPicture::taken, this, &SubmissionPanel::showJudgement);
    connect(student, &StudentPicture::taken, m_link, &CompareLink::fit);
    connect(student, &StudentPicture::judged, this, &SubmissionPanel::showJudgement);
    connect(playhead, &Playhead::pickedPixelChanged, this, &SubmissionPanel::showPixel);
    showJudgement();
}

void SubmissionPanel::addHead(QBoxLayout *layout)
{
    m_name
        = named(new ElidedLabel(m_content), "submissionName", tr("The student's picture's file"));
    m_name->setFont(bold(m_name->font()));
    auto *open = namedButton(
        "submissionOpen", tr("Open…"),
        tr("Open a student's picture: PNG, PPM, BMP, or a raster of “#” and “.”"), m_content);
    m_remove
        = namedButton("submissionRemove", tr("Remove"),
                      tr("Take the student's picture away; the scene stays as it is"), m_content);
    m_leeway = new LeewayBox("submissionLeeway", m_content);
    auto *row = withParts(new QHBoxLayout, {open, m_remove, Room()}, 4);
    auto *leewayRow
        = withParts(new QHBoxLayout, {new QLabel(tr("Leeway"), m_content), {m_leeway, 1}}, 4);
    layout->addWidget(m_name); // rows of their own: German words and file names are long
    layout->addLayout(row);
    layout->addLayout(leewayRow);
    connect(open, &QToolButton::clicked, this, &SubmissionPanel::openRequested);
    connect(m_remove, &QToolButton::clicked, m_student, &StudentPicture::remove);
    connect(m_leeway, &LeewayBox::leewayChosen, m_student, [this](Leeway leeway) {
        m_student->setMargin({leeway, m_student->margin().tolerance});
    });
}

void SubmissionPanel::addTexts(QBoxLayout *layout)
{
    m_verdict = readingLabel("submissionVerdict", tr("Verdict"), m_content);
    m_counts = readingLabel("submissionCounts", tr("Pixels by cause"), m_content);
    m_counts->setTextFormat(Qt::RichText);
    m_causes = readingLabel("submissionCauses", tr("What explains the whole picture"), m_content);
    for (QLabel *label : {m_verdict, m_counts, m_causes})
        layout->addWidget(label);
}

void SubmissionPanel::addPictures(QBoxLayout *layout)
{
    m_pictures = new QWidget(m_content);
    auto *column = withParts(new QVBoxLayout(m_pictures), {}, 4, 0);
    m_pair = withParts(new QBoxLayout(QBoxLayout::TopToBottom), {}, 4);
    column->addLayout(m_pair, 1);
    const auto addPicture = [this](const QString &title, SubmissionView *view) {
        m_pair->addLayout(withParts(new QVBoxLayout, {new QLabel(title, m_pictures), {view, 1}}, 4),
                          1);
    };
    m_found = new SubmissionView(SubmissionView::Side::Student, m_link, m_playhead, m_pictures);
    m_expected = new SubmissionView(SubmissionView::Side::Expected, m_link, m_playhead, m_pictures);
    addPicture(tr("Student"), m_found);
    addPicture(tr("Expected"), m_expected);
    m_next = namedButton("submissionNext", tr("Next difference"),
                         tr("Pick the next pixel that differs, in reading order"), m_pictures);
    m_pixel = readingLabel("submissionPixel", tr("The picked pixel"), m_pictures);
    column->addWidget(m_next);
    column->addWidget(m_pixel);
    layout->addWidget(m_pictures, 1);
    connect(m_next, &QToolButton::clicked, this, &SubmissionPanel::pickNext);
}

/// Makes the pictures as large as the panel lets them be, as high as the frame's shape asks: one
/// above the other where they then take little more than half of its height, else side by side.
void SubmissionPanel::fitPictures()
{
    const FrameSpec &frame = m_link->frame();
    const int room = m_content->width() - 16; // between the margins
    const auto heightAt = [&frame](int width) {
        return int(std::int64_t(width) * frame.height / std::max(1, frame.width));
    };
    const bool isBeside = 2 * heightAt(room) > height() * 3 / 5;
    m_pair->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    const int asked = heightAt(isBeside ? room / 2 : room);
    const int most = std::max(leastPicture, height() * 2 / 3);
    for (SubmissionView *view : {m_found, m_expected})
        view->setMinimumHeight(std::clamp(asked, leastPicture, most));
}

void SubmissionPanel::lookAt(const QPoint &pixel) { m_link->lookAt(pixel); }

void SubmissionPanel::pickNext()
{
    const auto &judgement = m_student->judgement();
    const auto next
        = judgement ? judgement->differenceAfter(m_playhead->pickedPixel()) : std::nullopt;
    if (!next)
        return;
    m_playhead->pick(*next);
    lookAt(*next);
}

void SubmissionPanel::showJudgement()
{
    const std::shared_ptr<const PictureJudgement> &judgement = m_student->judgement();
    const bool isThere = m_student->isThere();
    m_name->setWholeText(m_student->name().isEmpty() ? tr("No student's picture")
                                                     : m_student->name());
    m_remove->setEnabled(isThere);
    m_leeway->setLeeway(m_student->margin().leeway);
    m_pictures->setVisible(judgement != nullptr);
    m_diagnosis->setVisible(isThere);
    m_counts->setVisible(judgement != nullptr);
    const QString causes = judgement ? causesText(judgement->diff) : QString();
    m_causes->setText(causes);
    m_causes->setVisible(!causes.isEmpty());
    if (judgement) {
        m_verdict->setText(verdictText(judgement->diff));
        m_counts->setText(countsText(*judgement, palette()));
        m_link->setFrame(judgement->frame);
        fitPictures();
        m_next->setEnabled(judgement->firstDifference().has_value());
    } else if (!m_student->absence().isEmpty()) {
        m_verdict->setText(m_student->absence());
    } else if (!isThere) {
        m_verdict->setText(
            tr("Drop a picture of this scene on the canvas, paste it (Ctrl+V) or open it: PNG, "
               "PPM, BMP, or a raster of “#” and “.”. What differs is marked on the canvas."));
    } else {
        const QString misfit = m_student->misfit();
        m_verdict->setText(misfit.isEmpty() ? tr("Being compared.") : misfit);
    }
    m_found->setJudgement(judgement);
    m_expected->setJudgement(judgement);
    showPixel();
}

void SubmissionPanel::showPixel()
{
    const auto &judgement = m_student->judgement();
    const std::optional<QPoint> picked = m_playhead->pickedPixel();
    m_pixel->setText(judgement && picked ? pixelText(*judgement, *picked) : QString());
}

} // namespace pixelplumb
