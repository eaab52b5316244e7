// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowstatusbar.h"

#include "widgets/canvas/canvas.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenetracer.h"
#include "widgets/window/statusfields.h"

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
            &JobBar::cancelRequested, parts.files, &SceneFiles::cancelLoading);
    addJob(parts.files->saving(),
           {QStringLiteral("saveProgress"), tr("Progress of saving"), {}, {}});
    connect(addJob(parts.exports->writing(),
                   {QStringLiteral("exportProgress"), tr("Progress of exporting"),
                    QStringLiteral("cancelExport"), tr("Cancel exporting")}),
            &JobBar::cancelRequested, parts.exports, &SceneExports::cancelWriting);
    connect(addJob(parts.tracer->job(),
                   {QStringLiteral("traceProgress"), tr("Progress of tracing"),
                    QStringLiteral("cancelTrace"), tr("Cancel tracing")}),
            &JobBar::cancelRequested, parts.tracer, &SceneTracer::cancel);
    connect(parts.playhead, &Playhead::message, this, &WindowStatusBar::tellBriefly);
    connect(parts.document, &SceneDocument::verticesDropped, this, &WindowStatusBar::tellBriefly);
    connect(parts.exports, &SceneExports::notice, this, &WindowStatusBar::tellBriefly);
}

void WindowStatusBar::tellBriefly(const QString &text) { showMessage(text, messageTime); }

JobBar *WindowStatusBar::addJob(const Job &job, const JobBar::Names &names)
{
    auto *bar = new JobBar(&job, names);
    addPermanentWidget(bar);
    return bar;
}

void WindowStatusBar::addFields(const WindowParts &parts)
{
    auto *fields = new StatusFields(parts.playhead, parts.student);
    addWidget(fields, 1);
    connect(parts.canvas, &Canvas::hovered, fields, &StatusFields::setHovered);
}

} // namespace pixelplumb
