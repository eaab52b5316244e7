// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/coststack.h"

#include "widgets/lab/labtext.h"
#include "widgets/look/signs.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int aroundBars = 56; ///< for axis and margins, logical pixels
constexpr int betweenBars = 4; ///< logical pixels

} // namespace

std::optional<CostParts> costPartsOf(const Study &study, const LabRow &row)
{
    const StudyContender *contender = study.contender(row.contender);
    const StudyFamily *family = study.family(row.family);
    if (!contender || !contender->fit || !family || family->timedPixels == 0)
        return std::nullopt;
    const CostFit &fit = *contender->fit;
    const auto pixels = double(family->timedPixels);
    return CostParts{fit.perTriangle * double(family->timedTriangles) / pixels,
                     fit.perColumn * double(family->timedSpans(row.contender)) / pixels,
                     fit.perPixel};
}

CostStack::CostStack(QWidget *parent)
    : LabPlot("labCostStack", tr("Cost of set-up, columns and pixels"), parent)
{
    plot()->installEventFilter(this);
}

/// The wheel scrolls the area; the plot would consume it.
bool CostStack::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Wheel)
        return LabPlot::eventFilter(watched, event);
    event->ignore();
    return true;
}

int CostStack::neededHeight() const
{
    const int bars = int(m_bars.size());
    return bars == 0 ? 0 : aroundBars + bars * (fontMetrics().height() + betweenBars);
}

void CostStack::show(const SharedResults &results, const QString &family)
{
    m_results = results;
    m_family = family;
    m_bars = bars();
    updateGeometry();
    rebuild();
}

std::vector<CostStack::Bar> CostStack::bars() const
{
    if (!m_results)
        return {};
    const Study &study = *m_results;
    const StudyFamily *family = study.family(m_family);
    std::vector<Bar> bars;
    for (const StudyContender &contender : study.contenders) {
        const LabRow *row = study.row(contender.id, m_family);
        const std::optional<CostParts> parts = row ? costPartsOf(study, *row) : std::nullopt;
        if (!parts)
            continue;
        Bar bar{contender.label, *parts, {}};
        if (row->cost) {
            const Spread &time = row->cost->perDraw;
            const auto pixels = double(family->timedPixels);
            bar.measured = Spread{time.lower / pixels, time.median / pixels, time.upper / pixels};
        }
        bars.push_back(bar);
    }
    std::ranges::sort(bars, {}, [](const Bar &bar) { return bar.parts.sum(); });
    return bars;
}

void CostStack::build()
{
    QCPAxis *up = plot()->yAxis;
    // At both ends, since one may be scrolled out of view.
    plot()->xAxis2->setVisible(true);
    plot()->xAxis2->setLabel(tr("ns a pixel"));
    plot()->xAxis->grid()->setVisible(true);
    up->setTickLength(0);
    up->grid()->setVisible(false);
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    for (std::size_t i = 0; i < m_bars.size(); ++i)
        ticker->addTick(-double(i), m_bars[i].label);
    up->setTicker(ticker);
    up->setRange(-double(std::max<std::size_t>(m_bars.size(), 1)) + 0.4, 0.6);
    if (m_bars.empty()) {
        plot()->xAxis->setRange(0, 1);
        plot()->xAxis2->setRange(0, 1);
        return addMessage(tr("Set-up, columns and pixels stand apart when several families are "
                             "timed."));
    }
    addBars();
    addMeasured();
}

void CostStack::addBars()
{
    struct Part {
        QString name;
        double CostParts::*value;
        Sign sign;
        Qt::BrushStyle style;
        QString meaning;
    };
    const std::array<Part, 3> parts
        = {Part{tr("set-up"), &CostParts::setUp, Sign::PickedPixel, Qt::SolidPattern,
                tr("What a triangle takes before its first column, shared out among its pixels")},
           Part{tr("columns or rows"), &CostParts::columns, Sign::CurrentColumn, Qt::BDiagPattern,
                tr("What a column or a row takes, shared out among its pixels")},
           Part{tr("pixels"), &CostParts::pixels, Sign::LowerEdge, Qt::Dense4Pattern,
                tr("What a pixel takes by itself")}};
    QCPBars *before = nullptr;
    for (const Part &part : parts) {
        auto *shown = new QCPBars(plot()->yAxis, plot()->xAxis);
        const QColor colour = signColour(part.sign, palette());
        shown->setPen(QPen(colour, 1));
        shown->setBrush(QBrush(colour, part.style));
        shown->setWidth(0.6);
        addKey(shown, part.name, part.meaning);
        for (std::size_t i = 0; i < m_bars.size(); ++i)
            shown->addData(-double(i), m_bars[i].parts.*part.value);
        if (before)
            shown->moveAbove(before);
        before = shown;
    }
}

void CostStack::addMeasured()
{
    double most = 0;
    const QColor text = palette().color(QPalette::Text);
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        most = std::max(most, m_bars[i].parts.sum());
        if (!m_bars[i].measured)
            continue;
        const Spread &time = *m_bars[i].measured;
        most = std::max(most, time.upper);
        auto *bar = new QCPItemLine(plot());
        bar->setPen(QPen(text, 1));
        bar->setHead(QCPLineEnding(QCPLineEnding::esBar, 6));
        bar->setTail(QCPLineEnding(QCPLineEnding::esBar, 6));
        bar->start->setCoords(time.lower, -double(i));
        bar->end->setCoords(time.upper, -double(i));
    }
    QCPGraph *key = addKey(tr("measured"),
                           tr("The middle half of the measured times. The parts "
                              "come from a fit over all families and need not "
                              "add up to it."));
    key->setPen(QPen(text, 1));
    plot()->xAxis->setRange(0, most * 1.05);
    plot()->xAxis2->setRange(plot()->xAxis->range());
}

std::vector<QStringList> CostStack::numbers() const
{
    std::vector<QStringList> lines
        = {{QStringLiteral("contender"), QStringLiteral("setUpNsPerPixel"),
            QStringLiteral("columnsNsPerPixel"), QStringLiteral("pixelsNsPerPixel"),
            QStringLiteral("measuredNsPerPixelLower"), QStringLiteral("measuredNsPerPixel"),
            QStringLiteral("measuredNsPerPixelUpper")}};
    for (const Bar &bar : m_bars) {
        const auto measured = [&bar](double Spread::*part) {
            return bar.measured ? QString::number((*bar.measured).*part) : QString();
        };
        lines.push_back({bar.label, QString::number(bar.parts.setUp),
                         QString::number(bar.parts.columns), QString::number(bar.parts.pixels),
                         measured(&Spread::lower), measured(&Spread::median),
                         measured(&Spread::upper)});
    }
    return lines;
}

QString CostStack::textAt(const QPointF &position) const
{
    const auto i = std::lround(-plot()->yAxis->pixelToCoord(position.y()));
    if (i < 0 || std::size_t(i) >= m_bars.size()
        || !plot()->axisRect()->rect().contains(position.toPoint()))
        return {};
    const Bar &bar = m_bars[std::size_t(i)];
    QStringList lines
        = {QStringLiteral("<b>%1</b>").arg(bar.label.toHtmlEscaped()),
           tr("of a pixel's time, set-up %1 ns, columns or rows %2 ns, the pixel itself %3 ns")
               .arg(figureText(bar.parts.setUp), figureText(bar.parts.columns),
                    figureText(bar.parts.pixels))};
    if (bar.measured)
        lines.append(tr("measured: %1 ns").arg(spreadText(*bar.measured)));
    return lines.join(QStringLiteral("<br>"));
}

} // namespace pixelplumb
