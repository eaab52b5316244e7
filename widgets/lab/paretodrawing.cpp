// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/choicenames.h"
#include "widgets/lab/labmarks.h"
#include "widgets/lab/labtext.h"
#include "widgets/lab/paretoplot.h"
#include "widgets/look/signs.h"
#include "widgets/studies/accuracy/precisionplot.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int marginsOfAxis = 70; ///< logical pixels above and below the axis, together
constexpr double roomBeside = 1.25; ///< beside the outermost dots, as a factor
constexpr double waitingShare = 0.14; ///< of the axis, for dots without a time
constexpr double betweenWaiting = 15; ///< logical pixels

} // namespace

/// The ring around the dot of a contender much slower than its straight loop.
QPen ParetoPlot::missPen() const { return {palette().color(QPalette::Text), 1.5, Qt::DashLine}; }

QColor ParetoPlot::staircaseColour(LabKernel kernel) const
{
    return kernel == LabKernel::Plain ? translucent(palette().color(QPalette::Text), 0.6)
                                      : signColour(Sign::CurrentColumn, palette());
}

QCPScatterStyle ParetoPlot::styleOf(const Dot &dot) const
{
    const QCPScatterStyle style = kernelDot(arithmeticOf(dot.point), dot.point.kernel, palette());
    return dot.isTimed ? style : waitingDot(style);
}

void ParetoPlot::build()
{
    if (!m_axis)
        return;
    setAxes();
    if (m_dots.empty())
        return addMessage(tr("Nothing is judged here yet."));
    addRows();
    for (const LabKernel kernel : ownLabKernels)
        addStaircase(kernel);
    addKeys();
    layOut();
    setWaitingPlaces();
    for (const Dot &dot : m_dots)
        addStraight(dot);
    for (const Dot &dot : m_dots)
        addDot(dot);
    addLabels();
}

void ParetoPlot::setAxes()
{
    double low = 1;
    double high = 10;
    const ParetoPoint *reference = nullptr;
    for (const ParetoPoint &point : m_chart.points) {
        const bool isFirst = &point == &m_chart.points.front();
        const Spread straight = point.straight.value_or(point.cost);
        low = std::min({isFirst ? point.cost.lower : low, point.cost.lower, straight.lower});
        high = std::max({isFirst ? point.cost.upper : high, point.cost.upper, straight.upper});
        if (point.isReference())
            reference = &point;
    }
    low = std::max(low, 1e-3) / roomBeside;
    high = std::max(high, low) * roomBeside;
    if (!m_chart.untimed.empty())
        low /= std::pow(high / low, waitingShare / (1 - waitingShare));
    // In a low chart the numbers carry their unit, and the axis label gives up its room.
    setLogRange(plot()->xAxis, low, high, isLow() ? tr("%1 ns") : u"%1"_s);
    plot()->xAxis->setLabel(isLow()                      ? QString()
                                : m_chart.points.empty() ? tr("cost, ns a pixel: not known yet")
                                                         : tr("cost, ns a pixel"));
    setErrorTicks();
    QCPAxis *times = plot()->xAxis2;
    times->setVisible(reference && !isLow());
    if (times->visible()) {
        setLogRange(times, low / reference->cost.median, high / reference->cost.median, u"×%1"_s);
        times->setLabel(tr("times the assignment's method (column scan, float32)"));
    }
}

void ParetoPlot::setErrorTicks()
{
    const int most = std::max(2, (height() - marginsOfAxis) / (2 * fontMetrics().height()) - 2);
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    for (const ErrorScale::Tick &tick : m_scale.ticks(most))
        ticker->addTick(tick.axis, tick.label);
    plot()->yAxis->setTicker(ticker);
    plot()->yAxis->setRange(ErrorScale::bottom, m_scale.top());
    plot()->yAxis->setLabel(errorLabel(*m_axis, isLow() ? LabelLength::Short : LabelLength::Whole));
}

/// Places waiting dots side by side at the left, where their errors do not separate them.
void ParetoPlot::setWaitingPlaces()
{
    std::vector<QPointF> taken;
    for (Dot &dot : m_dots) {
        if (dot.isTimed)
            continue;
        QPointF place(plot()->axisRect()->left() + betweenWaiting * 0.8,
                      plot()->yAxis->coordToPixel(dot.error));
        const auto covers = [&place](const QPointF &other) {
            return std::hypot(other.x() - place.x(), other.y() - place.y()) < betweenWaiting - 1;
        };
        while (std::ranges::any_of(taken, covers))
            place.rx() += betweenWaiting;
        taken.push_back(place);
        dot.cost = plot()->xAxis->pixelToCoord(place.x());
    }
}

/// Adds the line between the rows of the zeros and the decades.
void ParetoPlot::addRows()
{
    auto *separator = new QCPItemStraightLine(plot());
    separator->setPen(QPen(translucent(palette().color(QPalette::Text), 0.35), 1));
    separator->point1->setCoords(1, m_scale.separator());
    separator->point2->setCoords(2, m_scale.separator());
}

void ParetoPlot::addStaircase(LabKernel kernel)
{
    const std::vector<StaircaseCorner> corners = m_chart.staircase(kernel);
    if (corners.empty())
        return;
    const bool isPlain = kernel == LabKernel::Plain;
    auto *stairs = new QCPCurve(plot()->xAxis, plot()->yAxis);
    stairs->setPen(QPen(staircaseColour(kernel), 1.5, isPlain ? Qt::SolidLine : Qt::DashLine));
    if (!isLow()) // the arithmetics need the legend's room
        addKey(stairs, isPlain ? tr("best plain kernels") : tr("best SIMD kernels"),
               isPlain ? tr("The frontier: no plain kernel, which draws one pixel at a time, "
                            "is as exact in less time than those on this line.")
                       : tr("The frontier of the SIMD kernels, which draw several pixels at "
                            "once. They are compared only with each other: they are faster "
                            "because of how they are programmed, not because of what they "
                            "compute."));
    QVector<double> costs;
    QVector<double> errors;
    for (const StaircaseCorner &corner : corners) {
        costs.append(corner.cost);
        errors.append(m_scale.toAxis(corner.errorClass, corner.error));
    }
    // Nothing is cheaper than the first, however wrong, nor more exact than the last.
    costs.prepend(costs.constFirst());
    errors.prepend(m_scale.top());
    costs.append(plot()->xAxis->range().upper);
    errors.append(errors.constLast());
    stairs->setData(costs, errors);
}

void ParetoPlot::addDot(const Dot &dot)
{
    const ParetoPoint &point = dot.point;
    if (dot.isTimed) {
        auto *bar = new QCPItemLine(plot());
        bar->setPen(QPen(arithmeticColour(arithmeticOf(point), palette()), 1));
        bar->setHead(QCPLineEnding(QCPLineEnding::esBar, 5));
        bar->setTail(QCPLineEnding(QCPLineEnding::esBar, 5));
        bar->start->setCoords(point.cost.lower, dot.error);
        bar->end->setCoords(point.cost.upper, dot.error);
    }
    const auto add = [&](const QCPScatterStyle &style) {
        QCPGraph *graph = plot()->addGraph();
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(style);
        graph->setData({dot.cost}, {dot.error}, true);
    };
    const auto ring = [](const QPen &pen, double size) {
        return QCPScatterStyle(QCPScatterStyle::ssCircle, pen, QBrush(Qt::NoBrush), size);
    };
    add(styleOf(dot));
    if (point.contender == m_selected)
        add(ring(QPen(palette().color(QPalette::Highlight), 2.5), 21));
    if (point.missesStraight)
        add(ring(missPen(), 15));
}

void ParetoPlot::addStraight(const Dot &dot)
{
    if (!dot.point.straight)
        return;
    const Arithmetic arithmetic = arithmeticOf(dot.point);
    const double cost = dot.point.straight->median;
    auto *way = new QCPItemLine(plot());
    way->setPen(QPen(arithmeticColour(arithmetic, palette()), 1, Qt::DotLine));
    way->start->setCoords(cost, dot.error);
    way->end->setCoords(dot.cost, dot.error);
    QCPGraph *loop = plot()->addGraph();
    loop->setLineStyle(QCPGraph::lsNone);
    loop->setScatterStyle(straightLoopDot(arithmetic, palette()));
    loop->setData({cost}, {dot.error}, true);
}

void ParetoPlot::addKeys()
{
    const auto hasAny = [this](const auto &test) { return std::ranges::any_of(m_dots, test); };
    const auto add
        = [this](const QString &name, const QCPScatterStyle &style, const QString &meaning = {}) {
              QCPGraph *key = addKey(name, meaning);
              key->setLineStyle(QCPGraph::lsNone);
              key->setScatterStyle(style);
          };
    for (const Arithmetic arithmetic : allArithmetics) {
        if (hasAny([&](const Dot &dot) { return arithmeticOf(dot.point) == arithmetic; }))
            add(nameText(nameOf(arithmetic)), kernelDot(arithmetic, LabKernel::Plain, palette()));
    }
    if (hasAny([](const Dot &dot) { return dot.point.kernel == LabKernel::Fast; }))
        add(tr("SIMD kernel"), kernelDot(Arithmetic::Exact, LabKernel::Fast, palette()),
            tr("A kernel that draws several pixels at once, by SIMD "
               "instructions. Tests check that it writes the same bytes as the "
               "plain kernel."));
    if (hasAny([](const Dot &dot) { return dot.point.kernel == LabKernel::Peer; }))
        add(tr("another renderer"), kernelDot(Arithmetic::Exact, LabKernel::Peer, palette()),
            tr("Code by others, measured in the same benchmark."));
    if (hasAny([](const Dot &dot) { return dot.point.straight.has_value(); }))
        add(tr("straight loop"), straightLoopDot(Arithmetic::Exact, palette()), straightLoopText());
    if (isLow())
        return;
    if (hasAny([](const Dot &dot) { return dot.point.missesStraight.has_value(); }))
        add(tr("over 1.3 × its loop"),
            QCPScatterStyle(QCPScatterStyle::ssCircle, missPen(), QBrush(Qt::NoBrush), 12),
            tr("It takes more than 1.3 times as long as its straight loop, so "
               "part of its cost is how it is programmed, not what it computes."));
    if (!m_chart.untimed.empty())
        add(tr("not timed (yet)"),
            waitingDot(kernelDot(Arithmetic::Exact, LabKernel::Plain, palette())),
            tr("Its error is known but its time is not yet: it waits at the "
               "left."));
}

} // namespace pixelplumb
