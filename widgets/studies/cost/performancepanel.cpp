// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost/performancepanel.h"

#include "widgets/look/numberformat.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/model/job.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/studypanel.h"

#include <cmath>

namespace pixelplumb {

namespace {

struct PerformanceText {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::PerformanceText)
};

/// A number with three digits, in groups of thousands.
QString rounded(double value)
{
    if (!(value > 0))
        return u"0"_s;
    const int places = std::clamp(2 - int(std::floor(std::log10(value))), 0, 4);
    return groupedText(value, places);
}

QString cell(const QString &text) { return u"<td align='right'>%1</td>"_s.arg(text); }

QString timeRow(const QString &who, const DrawTime &time, const SceneTiming &timing)
{
    const Spread &spread = time.perDraw;
    const auto percent = [&](double value) {
        return QString::number(std::abs(value / spread.median - 1) * 100, 'f', 0);
    };
    return u"<tr><td>%1</td>"_s.arg(who) + cell(rounded(time.perPixel(timing.pixels)))
        + cell(rounded(time.perTriangle(timing.triangles)))
        + cell(u"−%1 … +%2 %"_s.arg(percent(spread.lower), percent(spread.upper)))
        + cell(u"%1 ×"_s.arg(rounded(timing.plain.perDraw.median / time.perDraw.median)))
        + cell(u"%1 %"_s.arg(QString::number(100 * timing.shareOfMemory(time), 'f', 0)))
        + u"</tr>"_s;
}

QLabel *textLabel(const char *name, QWidget *parent)
{
    QLabel *label = readingLabel(name, {}, parent);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return label;
}

QLabel *headingLabel(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(u"<b>%1</b>"_s.arg(text), parent);
    label->setContentsMargins(0, 8, 0, 0);
    return label;
}

} // namespace

QString timesHtml(const SceneTiming &timing)
{
    QString html = u"<table width='100%' cellspacing='0' cellpadding='2'><tr><td></td>"_s;
    for (const QString &heading :
         {PerformanceText::tr("ns a pixel"), PerformanceText::tr("ns a triangle"),
          PerformanceText::tr("quartiles"), PerformanceText::tr("speed"),
          PerformanceText::tr("of memset")})
        html += cell(heading);
    html += u"</tr>"_s;
    html += timeRow(PerformanceText::tr("plain kernel"), timing.plain, timing);
    html += timeRow(PerformanceText::tr("fast, %1")
                        .arg(QString::fromUtf8(nameOf(timing.report.instructionSet))),
                    timing.fast, timing);
    if (timing.parallel) {
        html += timeRow(PerformanceText::tr("fast, %1 threads").arg(timing.parallel->threads),
                        *timing.parallel, timing);
    }
    html += timeRow(PerformanceText::tr("memory: memset"), timing.memory, timing);
    return html + u"</table>"_s;
}

QString routesHtml(const FastReport &report, const QPalette &palette)
{
    const QColor dim
        = blended(palette.color(QPalette::Window), palette.color(QPalette::WindowText), 0.72F);
    QString html = u"<table cellspacing='0' cellpadding='2'>"_s;
    for (const FastRouteUse &use : report.uses) {
        QString kernel = QString::fromUtf8(nameOf(use.kernel));
        if (use.word != ColourWord::Other)
            kernel += PerformanceText::tr(", colours: %1").arg(QString::fromUtf8(nameOf(use.word)));
        html += u"<tr>"_s + cell(groupedText(use.triangles))
            + u"<td>&nbsp;%1<br><span style='color:%2'>&nbsp;%3</span></td></tr>"_s.arg(
                kernel, dim.name(),
                QString::fromUtf8(pixelplumb::textOf(use.reason)).toHtmlEscaped());
    }
    return html + u"</table>"_s;
}

QString measurementText(const SceneTiming &timing)
{
    if (timing.triangles == 0)
        return PerformanceText::tr("The scene has no triangles to draw.");
    if (timing.pixels == 0)
        return PerformanceText::tr("The scene's triangles cover no pixel of the frame.");
    const QString triangles = PerformanceText::tr("%1 triangles", nullptr, int(timing.triangles))
                                  .arg(groupedText(timing.triangles));
    const QString pixels = PerformanceText::tr("%1 pixels", nullptr, int(timing.pixels))
                               .arg(groupedText(timing.pixels));
    return PerformanceText::tr("Column scan, %1, %2: %3, %4 written. Medians of %5 rounds. %6")
        .arg(QString::fromUtf8(nameOf(timing.settings.arithmetic)),
             QString::fromUtf8(nameOf(timing.settings.fillRule)), triangles, pixels,
             QString::number(timing.rounds),
             timing.sameBytes ? PerformanceText::tr("Both kernels draw the same bytes.")
                              : PerformanceText::tr("The kernels draw different bytes!"));
}

PerformancePanel::PerformancePanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_job(nullptr, measuringPool())
{
    named(this, "performance", tr("Performance"));
    QScrollArea *scroll = columnScroll(this);
    scroll->setAccessibleName(tr("Measurement"));
    scroll->setFocusPolicy(Qt::NoFocus); // its contents take the focus
    scroll->setWidget(contents());
    auto *layout = withParts(new QVBoxLayout(this), {controls(), {scroll, 1}}, 8);
    layout->setContentsMargins(8, 8, 0, 0);

    onEvents(this, {QEvent::PaletteChange, QEvent::FontChange}, [this] { present(); });
    connect(playhead, &Playhead::tracedChanged, this, &PerformancePanel::forget);
    forget();
}

QBoxLayout *PerformancePanel::controls()
{
    m_measure = named(new QPushButton(tr("Measure"), this), "performanceMeasure", {},
                      tr("Draw the scene repeatedly by the plain and the fast kernels in "
                         "turn, and time memset beside them"));
    auto *progress
        = new JobBar(m_job, u"performance"_s, tr("Progress of the measurement"), 160, this);
    auto *row = withParts(new QHBoxLayout, {m_measure, progress, Room()}, 8);
    row->setContentsMargins(0, 0, 8, 0);
    connect(m_measure, &QPushButton::clicked, this, &PerformancePanel::measure);
    connect(progress, &JobBar::cancelled, this, &PerformancePanel::cancel);
    return row;
}

QWidget *PerformancePanel::contents()
{
    auto *contents = new QWidget(this);
    m_summary = textLabel("performanceSummary", contents);
    m_times = textLabel("performanceTimes", contents);
    m_times->setAccessibleName(tr("Times"));
    m_times->setToolTip(tr("speed: relative to the plain kernel; of memset: how close the "
                           "time is to memset over as many pixels"));
    m_routes = textLabel("performanceRoutes", contents);
    m_routes->setAccessibleName(tr("Fast kernels used"));
    auto *layout = withParts(
        new QVBoxLayout(contents),
        {m_summary, m_times, headingLabel(tr("Fast kernels, and why"), contents), m_routes, Room()},
        8);
    layout->setContentsMargins(0, 0, 8, 8);
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
    tell(m_playhead->traced()
             ? tr("Press Measure to draw this scene repeatedly for about a second.")
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
    m_measure->setEnabled(!m_job.isRunning() && m_playhead->traced());
    const bool isTimed = m_timing && m_timing->rounds > 0;
    m_times->setVisible(isTimed);
    m_times->setText(isTimed ? timesHtml(*m_timing) : QString());
    m_routes->setText(isTimed ? routesHtml(m_timing->report, palette())
                              : tr("Known after a measurement."));
}

} // namespace pixelplumb
