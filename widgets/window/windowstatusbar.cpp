// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowstatusbar.h"

#include "widgets/canvas/canvas.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/corewords.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenetracer.h"
#include "widgets/window/statusfields.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace pixelplumb {

namespace {

constexpr int messageTime = 5000; // ms

} // namespace

WindowStatusBar::WindowStatusBar(const WindowParts &parts, QWidget *window)
    : QStatusBar(window)
{
    addFields(parts);
    connect(addJob(parts.files->loading(),
                   {QStringLiteral("loadProgress"), tr("Progress of opening"),
                    QStringLiteral("cancelLoad"), tr("Cancel opening")}),
            &QToolButton::clicked, parts.files, &SceneFiles::cancelLoading);
    addJob(parts.files->saving(),
           {QStringLiteral("saveProgress"), tr("Progress of saving"), {}, {}});
    connect(addJob(parts.exports->writing(),
                   {QStringLiteral("exportProgress"), tr("Progress of exporting"),
                    QStringLiteral("cancelExport"), tr("Cancel exporting")}),
            &QToolButton::clicked, parts.exports, &SceneExports::cancelWriting);
    connect(addJob(parts.tracer->job(),
                   {QStringLiteral("traceProgress"), tr("Progress of tracing"),
                    QStringLiteral("cancelTrace"), tr("Cancel tracing")}),
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
    auto *row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(title);
    row->addWidget(bar);
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
