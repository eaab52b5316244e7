// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jobprogress.h"

#include "widgets/sceneloader.h"
#include "widgets/scenesaver.h"
#include "widgets/scenetracer.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace pixelplumb {

JobProgress::JobProgress(const Names &names, QWidget *parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_bar(new QProgressBar(this))
{
    m_bar->setObjectName(names.bar);
    m_bar->setAccessibleName(names.barInWords);
    m_bar->setRange(0, 100);
    m_bar->setFixedWidth(160);
    m_bar->setMaximumHeight(16);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(m_title);
    row->addWidget(m_bar);
    hide();
    if (names.cancel.isEmpty())
        return;
    auto *cancel = new QToolButton(this);
    cancel->setObjectName(names.cancel);
    cancel->setText(tr("Cancel"));
    cancel->setAccessibleName(names.cancelInWords);
    cancel->setAutoRaise(true);
    row->addWidget(cancel);
    connect(cancel, &QToolButton::clicked, this, &JobProgress::cancelRequested);
}

void JobProgress::begin(const QString &title)
{
    m_title->setText(title);
    m_bar->setRange(0, 100);
    m_bar->setValue(0);
    show();
}

void JobProgress::setPercent(int percent) { m_bar->setValue(percent); }

void JobProgress::setBusy() { m_bar->setRange(0, 0); }

void JobProgress::end() { hide(); }

JobProgress *progressOf(SceneTracer *tracer, QWidget *parent)
{
    auto *progress
        = new JobProgress({QStringLiteral("traceProgress"), JobProgress::tr("Progress of tracing"),
                           QStringLiteral("cancelTrace"), JobProgress::tr("Cancel tracing")},
                          parent);
    QObject::connect(progress, &JobProgress::cancelRequested, tracer, &SceneTracer::cancel);
    QObject::connect(tracer, &SceneTracer::started, progress,
                     [progress] { progress->begin(JobProgress::tr("Tracing")); });
    QObject::connect(tracer, &SceneTracer::progressChanged, progress, &JobProgress::setPercent);
    QObject::connect(tracer, &SceneTracer::traced, progress, &JobProgress::end);
    QObject::connect(tracer, &SceneTracer::cancelled, progress, &JobProgress::end);
    QObject::connect(tracer, &SceneTracer::failed, progress, &JobProgress::end);
    return progress;
}

JobProgress *progressOf(SceneLoader *loader, QWidget *parent)
{
    auto *progress
        = new JobProgress({QStringLiteral("loadProgress"), JobProgress::tr("Progress of opening"),
                           QStringLiteral("cancelLoad"), JobProgress::tr("Cancel opening")},
                          parent);
    QObject::connect(progress, &JobProgress::cancelRequested, loader, &SceneLoader::cancel);
    QObject::connect(loader, &SceneLoader::started, progress, [progress](const QString &path) {
        progress->begin(JobProgress::tr("Opening %1").arg(QFileInfo(path).fileName()));
    });
    QObject::connect(loader, &SceneLoader::progressChanged, progress, &JobProgress::setPercent);
    QObject::connect(loader, &SceneLoader::finished, progress, &JobProgress::end);
    QObject::connect(loader, &SceneLoader::cancelled, progress, &JobProgress::end);
    return progress;
}

JobProgress *progressOf(SceneSaver *saver, QWidget *parent)
{
    auto *progress = new JobProgress(
        {QStringLiteral("saveProgress"), JobProgress::tr("Progress of saving"), {}, {}}, parent);
    QObject::connect(saver, &SceneSaver::started, progress, [progress](const QString &path) {
        progress->begin(JobProgress::tr("Saving %1").arg(QFileInfo(path).fileName()));
        progress->setBusy();
    });
    QObject::connect(saver, &SceneSaver::finished, progress, &JobProgress::end);
    return progress;
}

} // namespace pixelplumb
