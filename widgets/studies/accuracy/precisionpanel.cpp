// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy/precisionpanel.h"

#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/accuracy/precisionplot.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

PrecisionPanel::PrecisionPanel(Playhead *playhead, QWidget *parent)
    : StudyPanel("precision", {}, parent)
    , m_playhead(playhead)
{
    m_bound = named(new QComboBox(this), "precisionBound", tr("Bound"),
                    tr("Which bound's error is plotted"));
    m_bound->addItems({tr("lower bound"), tr("upper bound")});
    auto *controls = withParts(new QHBoxLayout, {m_bound}, 8);
    for (const Arithmetic arithmetic : allArithmetics) {
        if (arithmetic == Arithmetic::Exact)
            continue;
        auto *button = new QToolButton(this);
        button->setObjectName(u"precision_"_s + QString::fromUtf8(nameOf(arithmetic)));
        button->setText(QString::fromUtf8(nameOf(arithmetic)));
        button->setAccessibleName(tr("Show %1").arg(QString::fromUtf8(nameOf(arithmetic))));
        button->setToolTip(
            tr("Show or hide the curve of %1").arg(QString::fromUtf8(nameOf(arithmetic))));
        button->setCheckable(true);
        button->setChecked(true);
        connect(button, &QToolButton::toggled, this, &PrecisionPanel::showErrors);
        controls->addWidget(button);
        m_arithmetics.push_back(button);
    }
    controls->addStretch();
    m_plot = new PrecisionPlot(this);
    m_plot->setToolTip(tr("Dotted: the largest error that rounding can add up to after n "
                          "additions: n·ulp/2 in floating point, n·2⁻¹⁷ in 16.16, n·2⁻³³ "
                          "in 32.32. ≠: the first column that covers the wrong samples. A "
                          "click goes there."));
    m_summary = readingLabel("precisionSummary", {}, this);
    withParts(new QVBoxLayout(this), {controls, {m_plot, 1}, m_summary}, 8, 8);

    onEvents(this, {QEvent::Show}, [this] { followPosition(); });
    connect(m_bound, &QComboBox::currentIndexChanged, this, &PrecisionPanel::showErrors);
    connect(m_plot, &PrecisionPlot::coordinateClicked, this, &PrecisionPanel::jumpTo);
    connect(playhead, &Playhead::tracedChanged, this, &PrecisionPanel::restart);
    connect(playhead, &Playhead::positionChanged, this, &PrecisionPanel::followPosition);
    showErrors();
}

bool PrecisionPanel::beginStudy()
{
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    if (!traced) {
        take({});
        return false;
    }
    const std::optional<TraceStep> step = m_playhead->currentStep();
    m_triangle = step && traced->primitives.isTriangle(step->primitive) ? step->primitive : 0;
    m_job.start(
        [traced, triangle = m_triangle](const ProgressListener &listener) {
            return boundErrorsOf(traced->scene, triangle, listener);
        },
        [this](std::optional<std::vector<BoundErrors>> errors) {
            take(std::move(errors).value_or(std::vector<BoundErrors>()));
        });
    return true;
}

void PrecisionPanel::take(std::vector<BoundErrors> errors)
{
    m_errors = std::move(errors);
    const bool isRows
        = !m_errors.empty() && m_errors.front().spans.front().place.axis == SpanAxis::Row;
    m_bound->setItemText(0, isRows ? tr("left bound x_L") : tr("lower bound y_B"));
    m_bound->setItemText(1, isRows ? tr("right bound x_R") : tr("upper bound y_T"));
    for (std::size_t i = 0; i < m_arithmetics.size(); ++i) {
        m_arithmetics[i]->setEnabled(
            std::ranges::find(m_errors, allArithmetics[i + 1], &BoundErrors::arithmetic)
            != m_errors.end());
    }
    if (!m_errors.empty()) {
        const auto [first, last]
            = std::ranges::minmax(m_errors.front().spans, {},
                                  [](const BoundError &each) { return each.place.coordinate; });
        m_plot->showPlaces(first.place.coordinate, last.place.coordinate);
    }
    showErrors();
}

void PrecisionPanel::showErrors()
{
    std::vector<Arithmetic> shown;
    for (std::size_t i = 0; i < m_arithmetics.size(); ++i) {
        if (m_arithmetics[i]->isChecked())
            shown.push_back(allArithmetics[i + 1]);
    }
    m_plot->plot(m_errors, PlottedBound(m_bound->currentIndex()), shown);
    m_summary->setText(summary());
}

QString PrecisionPanel::summary() const
{
    if (m_errors.empty()) {
        const TracedScene *traced = m_playhead->traced();
        if (!traced)
            return tr("The scene is being drawn.");
        return tr("The method “%1” has no bounds that could be wrong here: it "
                  "tests every sample, or computes only in exact arithmetic, or "
                  "draws no triangle of this scene.")
            .arg(methodTitle(*traced->method));
    }
    QStringList parts;
    const auto bound = PlottedBound(m_bound->currentIndex());
    for (const BoundErrors &errors : m_errors) {
        double largest = 0;
        for (const BoundError &error : errors.spans)
            largest = std::max(largest, std::abs(valueOf(error, bound)));
        const auto isWrong = [&](const BoundError &error) { return isWrongAt(error, bound); };
        const auto firstWrong = std::ranges::find_if(errors.spans, isWrong);
        QString part = tr("%1: at most %2 px")
                           .arg(QString::fromUtf8(nameOf(errors.arithmetic)),
                                QString::number(largest, 'g', 2));
        const bool isRows = errors.spans.front().place.axis == SpanAxis::Row;
        if (firstWrong != errors.spans.end()) {
            const std::int64_t first = firstWrong->place.coordinate;
            part += (isRows ? tr(", rows wrong: %1, the first at y = %2")
                            : tr(", columns wrong: %1, the first at x = %2"))
                        .arg(std::ranges::count_if(errors.spans, isWrong))
                        .arg(first);
        } else {
            part += isRows ? tr(", no row wrong") : tr(", no column wrong");
        }
        parts.append(part);
    }
    return tr("Triangle %1. ").arg(m_triangle) + parts.join(u"; "_s) + QLatin1Char('.');
}

void PrecisionPanel::followPosition()
{
    if (!isVisible())
        return;
    const std::optional<TraceStep> step = m_playhead->currentStep();
    const TracedScene *traced = m_playhead->traced();
    if (step && traced && traced->primitives.isTriangle(step->primitive)
        && step->primitive != m_triangle)
        restart();
    m_plot->setCurrentPlace(m_playhead->currentPlace());
}

void PrecisionPanel::jumpTo(std::int64_t coordinate)
{
    const TracedScene *traced = m_playhead->traced();
    if (!traced || m_errors.empty() || m_triangle >= traced->trace->primitiveCount())
        return;
    const auto &spans = m_errors.front().spans;
    coordinate
        = std::clamp(coordinate, spans.front().place.coordinate,
                     std::max(spans.front().place.coordinate, spans.back().place.coordinate));
    const auto span = traced->trace->spanOn(m_triangle, spans.front().place.axis, coordinate);
    if (span)
        m_playhead->seekToSpan(*span);
}

} // namespace pixelplumb
