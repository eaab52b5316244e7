// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowstatusbar.h"

#include "core/scan/choicenames.h"
#include "core/scene/text/colourtext.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/corewords.h"
#include "widgets/look/labels.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenetracer.h"
#include "widgets/model/steptext.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/grade/submissionview.h"

namespace pixelplumb {

namespace {

void keepWide(QLabel *label, const QString &widest)
{
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 8);
}

constexpr int messageTime = 5000; // ms

} // namespace

StatusFields::StatusFields(const Playhead *playhead, const StudentPicture *student, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_student(student)
    , m_row(new QHBoxLayout(this))
{
    setObjectName(u"statusFields"_s);
    m_row->setContentsMargins(8, 0, 8, 0);
    m_row->setSpacing(8);
    m_pixel = addField(u"statusPixel"_s);
    m_column = addField(u"statusColumn"_s);
    m_step = addField(u"statusStep"_s);
    m_settings = addField(u"statusSettings"_s);
    addLine();
    m_verdict
        = named(new ElidedLabel(this), "statusFigures", tr("Wrong pixels of the finished picture"));
    m_row->addWidget(m_verdict, 1);
    connect(playhead, &Playhead::tracedChanged, this, &StatusFields::takeTrace);
    connect(playhead, &Playhead::positionChanged, this, [this] { refresh(); });
    connect(playhead, &Playhead::pickedPixelChanged, this, [this] { refresh(); });
    connect(student, &StudentPicture::judged, this, &StatusFields::tellVerdict);
    takeTrace();
}

void StatusFields::setHovered(std::optional<QPoint> pixel)
{
    m_hovered = pixel;
    refresh();
}

void StatusFields::addLine()
{
    auto *line = new QFrame(this);
    line->setFrameShape(QFrame::VLine);
    line->setForegroundRole(QPalette::Mid);
    m_row->addWidget(line);
}

QLabel *StatusFields::addField(const QString &name)
{
    if (m_row->count() > 0)
        addLine();
    auto *label = new QLabel(this);
    label->setObjectName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_row->addWidget(label);
    return label;
}

void StatusFields::takeTrace()
{
    if (const TracedScene *traced = m_playhead->traced()) {
        const FrameSpec &frame = traced->scene.frame;
        const auto widest = [](std::int64_t first, std::int64_t size) {
            const auto digits
                = std::max(QString::number(first).size(), QString::number(first + size - 1).size());
            return QString(std::max<qsizetype>(3, digits), QLatin1Char('8'));
        };
        const QString x = widest(frame.firstColumn, frame.width);
        const QString y = widest(frame.firstRow, frame.height);
        const QString end = widest(0, std::int64_t(m_playhead->end()) + 1);
        keepWide(m_pixel, tr("pixel (%1, %2) %3").arg(x, y, u"#dddddd"_s));
        keepWide(m_column, tr("column %1, second half").arg(x));
        keepWide(m_step, tr("step %1 of %2").arg(end, end));
        const ScanSettings &settings = traced->scene.settings;
        QStringList words{
            coreWord(nameOf(settings.arithmetic)), coreWord(nameOf(settings.fillRule)),
            frame.origin == FrameOrigin::BottomLeft ? tr("y upward") : tr("y downward")};
        if (frame.pixelCentre == PixelCentre::Half)
            words += tr("samples at ½");
        for (const Variant variant : variantsIn(settings.variants))
            words += nameText(wordsOf(variant, traced->method->spanAxis).title);
        if (traced->trace->isCut())
            words += tr("recording cut at its limit");
        m_settings->setText(words.join(u" · "_s));
    } else {
        m_settings->clear();
    }
    tellVerdict();
    refresh();
}

/// One verdict at a time.
void StatusFields::tellVerdict()
{
    const TracedScene *traced = m_playhead->traced();
    const QString verdict = traced ? verdictNote(*traced) : QString();
    if (const auto &judgement = m_student->judgement()) {
        m_verdict->setWholeText(tr("Submission: %1").arg(verdictText(judgement->diff)));
        m_verdict->setToolTip(verdict.isEmpty() ? QString()
                                                : tr("The method itself: %1").arg(verdict));
        return;
    }
    m_verdict->setWholeText(verdict);
    const bool isProved = traced && traced->differences.total() == 0
        && traced->method->isStableUnder(traced->scene.settings);
    m_verdict->setToolTip(verdict.isEmpty() || !isProved ? verdict
                                                         : verdict + u'\n'
                                  + tr("The method is proved to draw every pixel right."));
}

void StatusFields::refresh()
{
    const TracedScene *traced = m_playhead->traced();
    m_pixel->setText(pixelText());
    m_column->setText(traced ? columnText(*traced, m_playhead->position()) : QString());
    m_step->setText(traced ? tr("step %1 of %2").arg(m_playhead->position()).arg(m_playhead->end())
                           : QString());
}

QString StatusFields::pixelText() const
{
    const std::optional<QPoint> pixel = m_hovered ? m_hovered : m_playhead->pickedPixel();
    const FrameBuffer *frame = m_playhead->frame();
    if (!pixel || !frame || !frame->view().contains(pixel->x(), pixel->y()))
        return tr("no pixel");
    return tr("pixel (%1, %2) %3")
        .arg(pixel->x())
        .arg(pixel->y())
        .arg(colourText(unpacked(*frame->view().at(pixel->x(), pixel->y()))));
}

WindowStatusBar::WindowStatusBar(const WindowParts &parts, QWidget *window)
    : QStatusBar(window)
{
    addFields(parts);
    connect(addJob(parts.files->loading(),
                   {u"loadProgress"_s, tr("Progress of opening"), u"cancelLoad"_s,
                    tr("Cancel opening")}),
            &QToolButton::clicked, parts.files, &SceneFiles::cancelLoading);
    addJob(parts.files->saving(), {u"saveProgress"_s, tr("Progress of saving"), {}, {}});
    connect(addJob(parts.exports->writing(),
                   {u"exportProgress"_s, tr("Progress of exporting"), u"cancelExport"_s,
                    tr("Cancel exporting")}),
            &QToolButton::clicked, parts.exports, &SceneExports::cancelWriting);
    connect(addJob(parts.tracer->job(),
                   {u"traceProgress"_s, tr("Progress of tracing"), u"cancelTrace"_s,
                    tr("Cancel tracing")}),
            &QToolButton::clicked, parts.tracer, &SceneTracer::cancel);
    connect(parts.playhead, &Playhead::message, this, &WindowStatusBar::tellBriefly);
    connect(parts.document, &SceneDocument::verticesDropped, this, &WindowStatusBar::tellBriefly);
    connect(parts.exports, &SceneExports::notice, this, &WindowStatusBar::tellBriefly);
}

void WindowStatusBar::tellBriefly(const QString &text) { showMessage(text, messageTime); }

QToolButton *WindowStatusBar::addJob(const Job &job, const JobNames &names)
{
    auto *whole = new QWidget(this);
    auto *title = new QLabel(whole);
    auto *bar = new QProgressBar(whole);
    bar->setObjectName(names.bar);
    bar->setAccessibleName(names.barInWords);
    bar->setFixedWidth(160);
    bar->setMaximumHeight(16);
    auto *row = withParts(new QHBoxLayout(whole), {title, bar}, 8);
    row->setContentsMargins(0, 0, 8, 0);
    addPermanentWidget(whole);
    whole->hide();
    connect(&job, &Job::started, whole, [whole, title, bar, &job] {
        title->setText(job.title());
        bar->setRange(0, 0); // busy: the progress is unknown
        whole->show();
    });
    // Each phase counts from 0; the tool tip names it.
    connect(&job, &Job::progressChanged, bar, [bar](const JobProgress &progress) {
        bar->setToolTip(coreWord(nameOf(progress.phase)));
        bar->setRange(0, progress.total > 0 ? 100 : 0);
        if (progress.total > 0)
            bar->setValue(int(100 * progress.done / progress.total));
    });
    connect(&job, &Job::ended, whole, &QWidget::hide);
    if (names.cancel.isEmpty())
        return nullptr;
    auto *cancel = new QToolButton(whole);
    cancel->setObjectName(names.cancel);
    cancel->setText(tr("Cancel"));
    cancel->setAccessibleName(names.cancelInWords);
    cancel->setAutoRaise(true);
    row->addWidget(cancel);
    return cancel;
}

void WindowStatusBar::addFields(const WindowParts &parts)
{
    auto *fields = new StatusFields(parts.playhead, parts.student);
    addWidget(fields, 1);
    connect(parts.canvas, &Canvas::hovered, fields, &StatusFields::setHovered);
}

} // namespace pixelplumb
