// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/performancepanel.h"

#include "widgets/look/numberlayout.h"
#include "widgets/model/measuringpool.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/performancetext.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace pixelplumb {

namespace {

QLabel *textLabel(const char *name, QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    if (const QFont figures = tabularFont(parent->font()); figures != parent->font())
        label->setFont(figures);
    return label;
}

QLabel *headingLabel(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(QStringLiteral("<b>%1</b>").arg(text), parent);
    label->setContentsMargins(0, 8, 0, 0);
    return label;
}

} // namespace

PerformancePanel::PerformancePanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_job(nullptr, measuringPool())
{
    setObjectName(QStringLiteral("performance"));
    setAccessibleName(tr("Performance"));
    auto *scroll = new QScrollArea(this);
    scroll->setAccessibleName(tr("Measurement"));
    scroll->setFocusPolicy(Qt::NoFocus); // its contents take the focus
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(contents());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 0, 0);
    layout->setSpacing(8);
    layout->addLayout(controls());
    layout->addWidget(scroll, 1);

    connect(&m_job, &Job::progressChanged, this, &PerformancePanel::tellProgress);
    connect(playhead, &Playhead::tracedChanged, this, &PerformancePanel::forget);
    forget();
}

PerformancePanel::~PerformancePanel() = default;

QBoxLayout *PerformancePanel::controls()
{
    m_measure = new QPushButton(tr("Measure"), this);
    m_measure->setObjectName(QStringLiteral("performanceMeasure"));
    m_measure->setToolTip(tr("Draw the scene again and again by the plain and the fast kernels in "
                             "turn, beside memset"));
    m_progress = new QProgressBar(this);
    m_progress->setObjectName(QStringLiteral("performanceProgress"));
    m_progress->setAccessibleName(tr("Progress of the measurement"));
    m_progress->setTextVisible(false);
    m_progress->setMaximumWidth(160);
    m_cancel = new QPushButton(tr("Cancel"), this);
    m_cancel->setObjectName(QStringLiteral("performanceCancel"));
    auto *row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(m_measure);
    row->addWidget(m_progress);
    row->addWidget(m_cancel);
    row->addStretch();
    connect(m_measure, &QPushButton::clicked, this, &PerformancePanel::measure);
    connect(m_cancel, &QPushButton::clicked, this, &PerformancePanel::cancel);
    return row;
}

QWidget *PerformancePanel::contents()
{
    auto *contents = new QWidget(this);
    m_summary = textLabel("performanceSummary", contents);
    m_times = textLabel("performanceTimes", contents);
    m_times->setAccessibleName(tr("Times"));
    m_times->setToolTip(tr("speed: times that of the plain kernel; of memory: how near the time is "
                           "to that of memset over as many pixels"));
    m_routes = textLabel("performanceRoutes", contents);
    m_routes->setAccessibleName(tr("Fast kernels used"));
    auto *layout = new QVBoxLayout(contents);
    layout->setContentsMargins(0, 0, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(m_summary);
    layout->addWidget(m_times);
    layout->addWidget(headingLabel(tr("Fast kernels, and why"), contents));
    layout->addWidget(m_routes);
    layout->addStretch();
    return contents;
}

void PerformancePanel::measure()
{
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    if (!traced)
        return;
    m_timing.reset();
    tell(measuringNote());
    m_job.start(
        [traced](const ProgressListener &listener) {
            TimingOptions options;
            options.progress = listener;
            return timeScene(traced->scene, options);
        },
        [this](std::optional<SceneTiming> timing) { take(std::move(timing)); });
    m_progress->setRange(0, 0);
    present();
}

void PerformancePanel::cancel()
{
    m_job.cancel();
    present();
    tell(tr("The measurement was cancelled."));
}

void PerformancePanel::forget()
{
    m_job.cancel();
    m_timing.reset();
    present();
    tell(m_playhead->traced() ? tr("Measure draws this scene for a second or so.")
                              : tr("The scene is being drawn."));
}

void PerformancePanel::take(std::optional<SceneTiming> timing)
{
    m_timing = std::move(timing);
    present();
    tell(m_timing ? measurementText(*m_timing)
                  : tr("The measurement does not fit into memory. Make the frame smaller."));
    emit measured();
}

void PerformancePanel::tell(const QString &text)
{
    m_summary->setText(text);
    setAccessibleDescription(text);
}

void PerformancePanel::present()
{
    const bool isRunning = m_job.isRunning();
    m_measure->setEnabled(!isRunning && m_playhead->traced());
    m_progress->setVisible(isRunning);
    m_cancel->setVisible(isRunning);
    const bool isTimed = m_timing && m_timing->rounds > 0;
    m_times->setVisible(isTimed);
    m_times->setText(isTimed ? timesHtml(*m_timing) : QString());
    m_routes->setText(isTimed ? routesHtml(m_timing->report, palette())
                              : tr("Known after a measurement."));
}

void PerformancePanel::tellProgress(const JobProgress &progress)
{
    m_progress->setRange(0, int(progress.total));
    m_progress->setValue(int(progress.done));
}

void PerformancePanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (m_routes && (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange))
        present();
}

} // namespace pixelplumb
