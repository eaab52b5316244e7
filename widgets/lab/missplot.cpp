// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/missplot.h"

#include "widgets/look/signs.h"
#include "widgets/studies/accuracy/precisionscale.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int narrow = 560; ///< logical pixels
constexpr int wide = 760; ///< logical pixels
constexpr double tiePlace = 0.5; ///< of the ties' two bars, on both sides of 0
constexpr double barWidth = 0.8;
constexpr double baseline = 0.5; ///< of a logarithmic axis of counts: a count of 1 is visible
constexpr double firstBin = 2; ///< place of the bin nearest to the boundary
constexpr double farthest = firstBin + double(MissHistogram::bins);

QString binText(std::size_t bin)
{
    const auto power
        = [](double distance) { return powerOfTenText(int(std::lround(std::log10(distance)))); };
    if (bin == 0)
        return MissPlot::tr("nearer than %1 px").arg(power(MissHistogram::lowerEnd(1)));
    if (bin + 1 == MissHistogram::bins)
        return MissPlot::tr("farther than %1 px").arg(power(MissHistogram::lowerEnd(bin)));
    return MissPlot::tr("%1 to %2 px")
        .arg(power(MissHistogram::lowerEnd(bin)), power(MissHistogram::lowerEnd(bin + 1)));
}

} // namespace

MissPlot::MissPlot(QWidget *parent)
    : LabPlot("labMisses", tr("Distances of missed samples from the boundary"), parent)
{
}

double MissPlot::placeOf(Side side, std::size_t bin)
{
    return (side == Side::Missing ? -1 : 1) * (firstBin + double(bin));
}

void MissPlot::show(const SharedResults &results, const QString &family, const QString &contender)
{
    m_results = results;
    m_family = family;
    m_contender = contender;
    m_bars = bars();
    rebuild();
}

std::vector<MissPlot::Bar> MissPlot::bars() const
{
    const LabRow *row = m_results ? m_results->row(m_contender, m_family) : nullptr;
    if (!row || !row->accuracy)
        return {};
    const AccuracyFigures &figures = *row->accuracy;
    std::vector<Bar> bars;
    for (std::size_t bin = 0; bin < MissHistogram::bins; ++bin) {
        bars.push_back({placeOf(Side::Missing, bin), figures.misses.missing[bin],
                        tr("missing, %1 inside").arg(binText(bin))});
        bars.push_back({placeOf(Side::Extra, bin), figures.misses.extra[bin],
                        tr("extra, %1 outside").arg(binText(bin))});
    }
    bars.push_back({-tiePlace, figures.tiesMissing, tr("ties, missing: exactly on the boundary")});
    bars.push_back({tiePlace, figures.tiesExtra, tr("ties, extra: exactly on the boundary")});
    std::ranges::sort(bars, {}, &Bar::place);
    return bars;
}

void MissPlot::build()
{
    QCPAxis *across = plot()->xAxis;
    QCPAxis *up = plot()->yAxis;
    across->setRange(-farthest, farthest);
    across->setLabel(width() < wide
                         ? tr("? px inside   ←   =   →   ! px outside")
                         : tr("? missing, px inside   ←   = on the boundary   →   ! extra, px "
                              "outside"));
    up->setLabel(tr("samples"));
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    ticker->addTick(0, u"="_s);
    // A tick marks the bin's nearer end, between two bars.
    const int stride = width() < narrow ? 4 : width() < wide ? 3 : 2;
    for (int exponent = -7; exponent <= 2; exponent += stride) {
        const double place = firstBin + 0.5 + exponent + 7;
        ticker->addTick(place, powerOfTenText(exponent));
        ticker->addTick(-place, QChar(0x2212) + powerOfTenText(exponent));
    }
    across->setTicker(ticker);
    std::int64_t most = 0;
    for (const Bar &bar : m_bars)
        most = std::max(most, bar.count);
    setLogRange(up, baseline, 10 * double(std::max<std::int64_t>(most, 5)));
    if (m_bars.empty())
        return addMessage(tr("Nothing is known about this contender here."));
    if (most == 0)
        return addMessage(tr("No sample is missed."));
    addBars(-farthest, -1, Qt::Dense4Pattern, signColour(Sign::Missing, palette()),
            tr("? missing"));
    addBars(-1, 1, Qt::SolidPattern, signColour(Sign::Tie, palette()), tr("= ties"));
    addBars(1, farthest, Qt::BDiagPattern, signColour(Sign::Extra, palette()), tr("! extra"));
    for (const Bar &bar : m_bars) {
        if (bar.count == 0)
            continue;
        auto *count = new QCPItemText(plot());
        count->setText(QString::number(bar.count));
        count->setFont(smallFont());
        count->setColor(palette().color(QPalette::Text));
        count->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        count->position->setCoords(bar.place, double(bar.count));
    }
}

void MissPlot::addBars(double from, double to, Qt::BrushStyle style, const QColor &colour,
                       const QString &name)
{
    auto *shown = new QCPBars(plot()->xAxis, plot()->yAxis);
    shown->setBaseValue(baseline);
    shown->setWidth(barWidth);
    shown->setPen(QPen(colour, 1));
    shown->setBrush(QBrush(colour, style));
    addKey(shown, name, {});
    for (const Bar &bar : m_bars) {
        if (bar.place > from && bar.place < to && bar.count > 0)
            shown->addData(bar.place, double(bar.count) - baseline); // bars begin at the base
    }
}

QString MissPlot::figureTitle() const
{
    const StudyContender *contender = m_results ? m_results->contender(m_contender) : nullptr;
    const QString title = titleOn(m_results, m_family);
    return contender ? tr("%1; %2").arg(title, contender->label) : title;
}

QString MissPlot::textAt(const QPointF &position) const
{
    const double place = plot()->xAxis->pixelToCoord(position.x());
    for (const Bar &bar : m_bars) {
        if (std::abs(bar.place - place) <= barWidth / 2 && bar.count > 0)
            return u"%1: %2"_s.arg(bar.meaning).arg(bar.count);
    }
    return {};
}

} // namespace pixelplumb
