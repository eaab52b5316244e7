// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/performancepanel.h"

#include "widgets/look/numberlayout.h"
#include "widgets/model/measuringpool.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/performancecachelines.h"
#include "widgets/studies/performancetext.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <bit>

namespace pixelplumb {

namespace {

constexpr std::int64_t stripColumns = 16; // of the fast kernels' strips: a cache line

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
    scroll->setFocusPolicy(Qt::NoFocus); // what stands in it takes the focus
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
    connect(m_stride, &QComboBox::currentIndexChanged, this, &PerformancePanel::showCacheLines);
    connect(playhead, &Playhead::tracedChanged, this, &PerformancePanel::forget);
    connect(playhead, &Playhead::pickedPixelChanged, this, &PerformancePanel::showCacheLines);
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
    m_stride = new QComboBox(contents);
    m_stride->setObjectName(QStringLiteral("performanceStride"));
    m_stride->setAccessibleName(tr("Distance of the rows"));
    m_cacheLines = new PerformanceCacheLines(contents);
    m_cacheLines->setToolTip(
        tr("The lowest rows of the strip through the picked pixel; each bar is a line of the "
           "cache, each dot asks for another one. Below: how many of the strip's lines, from the "
           "lowest row to the highest, fall on each set of the first-level cache."));
    auto *layout = new QVBoxLayout(contents);
    layout->setContentsMargins(0, 0, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(m_summary);
    layout->addWidget(m_times);
    layout->addWidget(headingLabel(tr("Fast kernels, and why"), contents));
    layout->addWidget(m_routes);
    layout->addWidget(headingLabel(tr("What a strip of columns asks of the cache"), contents));
    layout->addWidget(m_stride, 0, Qt::AlignLeft);
    layout->addWidget(m_cacheLines);
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
    showCacheLines();
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

void PerformancePanel::showCacheLines()
{
    const FrameBuffer *frame = m_playhead->frame();
    m_stride->setEnabled(frame != nullptr);
    if (!frame || !isVisible())
        return;
    const FrameView view = frame->view();
    const auto rowBytes = std::int64_t(view.stride) * std::int64_t(sizeof(QRgb));
    const auto unpadded = std::int64_t(view.width) * std::int64_t(sizeof(QRgb));
    const std::array<std::int64_t, 3> distances
        = {rowBytes, unpadded, std::int64_t(std::bit_ceil(std::uint64_t(unpadded)))};
    const std::array<QString, 3> texts
        = {tr("rows as they are, %1 bytes apart"), tr("rows without padding, %1 bytes apart"),
           tr("rows at a power of two, %1 bytes apart")};
    const QSignalBlocker blocker(m_stride);
    for (int i = 0; i < int(distances.size()); ++i) {
        if (m_stride->count() == i)
            m_stride->addItem({});
        m_stride->setItemText(i, texts[std::size_t(i)].arg(std::abs(distances[std::size_t(i)])));
    }
    PixelPlaces places(view);
    places.bytesPerRow = distances[std::size_t(std::max(0, m_stride->currentIndex()))];

    const std::int64_t picked = m_playhead->pickedPixel()
        ? m_playhead->pickedPixel()->x() - view.firstColumn
        : view.width / 2;
    PixelBlock block;
    block.columns = std::min<std::int64_t>(stripColumns, view.width);
    block.firstColumn = std::clamp<std::int64_t>(picked / stripColumns * stripColumns, 0,
                                                 view.width - block.columns);
    block.rows = view.height;
    m_cacheLines->showStrip(places, block, firstLevelDataCache());
}

void PerformancePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    showCacheLines();
}

void PerformancePanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (m_routes && (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange))
        present();
}

} // namespace pixelplumb
