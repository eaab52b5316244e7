// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/paretoplot.h"

#include "core/scan/choicenames.h"
#include "widgets/lab/labelplaces.h"
#include "widgets/lab/labmarks.h"
#include "widgets/lab/labtext.h"
#include "widgets/studies/precisionplot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pixelplumb {

namespace {

constexpr double reach = 12; ///< logical pixels from a dot to a pointer that means it
constexpr int marginsOfAxis = 70; ///< logical pixels above and below the axis, together
constexpr int lowHeight = 220; ///< logical pixels
constexpr double room = 1.25; ///< beside the outermost dots, as a factor

} // namespace

ParetoPlot::ParetoPlot(QWidget *parent)
    : LabPlot("labPareto", tr("Cost against error"), parent)
{
}

void ParetoPlot::show(const SharedResults &results, const QString &family, const ErrorAxis &axis)
{
    m_results = results;
    m_family = family;
    m_axis = &axis;
    m_chart = results ? paretoOf(results->study, family, axis) : ParetoChart();
    m_scale = ErrorScale(m_chart.points);
    rebuild();
}

void ParetoPlot::select(const QString &contender)
{
    if (contender == m_selected)
        return;
    m_selected = contender;
    rebuild();
}

/// Around the dot of who takes much longer than a straight loop.
QPen ParetoPlot::missPen() const { return {palette().color(QPalette::Text), 1.5, Qt::DashLine}; }

Arithmetic ParetoPlot::arithmeticOf(const ParetoPoint &point) const
{
    const LabRow *row = m_results->study.row(point.contender, m_family);
    return row ? row->settings.arithmetic : Arithmetic::Exact;
}

QPointF ParetoPlot::placeOf(const ParetoPoint &point) const
{
    return {plot()->xAxis->coordToPixel(point.cost.median),
            plot()->yAxis->coordToPixel(m_scale.toAxis(point.errorClass, point.error))};
}

std::optional<QPointF> ParetoPlot::positionOf(const QString &contender) const
{
    const auto point = std::ranges::find(m_chart.points, contender, &ParetoPoint::contender);
    if (point == m_chart.points.end())
        return std::nullopt;
    return plot()->mapTo(this, placeOf(*point));
}

const ParetoPoint *ParetoPlot::pointAt(const QPointF &position) const
{
    const ParetoPoint *nearest = nullptr;
    double least = reach;
    for (const ParetoPoint &point : m_chart.points) {
        const QPointF way = placeOf(point) - position;
        if (const double distance = std::hypot(way.x(), way.y()); distance <= least) {
            least = distance;
            nearest = &point;
        }
    }
    return nearest;
}

QString ParetoPlot::textAt(const QPointF &position) const
{
    const ParetoPoint *point = pointAt(position);
    return point ? pointHtml(m_results->study, *point, m_family) : QString();
}

void ParetoPlot::clickAt(const QPointF &position)
{
    if (const ParetoPoint *point = pointAt(position))
        emit contenderClicked(QString(point->contender));
}

void ParetoPlot::build()
{
    if (!m_axis)
        return;
    setAxes();
    if (m_chart.points.empty()) {
        addMessage(tr("No contender has both an error and a time here: while a study runs, times "
                      "come last; hard cases are not timed."));
        return;
    }
    addStaircase();
    for (const ParetoPoint &point : m_chart.points)
        addStraight(point);
    for (const ParetoPoint &point : m_chart.points)
        addPoint(point);
    addKeys();
    plot()->replot(); // labels need the places of the dots
    addLabels();
}

void ParetoPlot::setAxes()
{
    double low = 1;
    double high = 10;
    if (!m_chart.points.empty()) {
        low = m_chart.points.front().cost.lower;
        high = low;
        for (const ParetoPoint &point : m_chart.points) {
            low = std::min({low, point.cost.lower, point.straight.value_or(point.cost).lower});
            high = std::max({high, point.cost.upper, point.straight.value_or(point.cost).upper});
        }
    }
    low = std::max(low, 1e-3) / room;
    high = std::max(high, low) * room;
    setLogRange(plot()->xAxis, low, high);
    plot()->xAxis->setLabel(tr("cost, ns a pixel"));
    const int most = std::max(2, (height() - marginsOfAxis) / (2 * fontMetrics().height()) - 2);
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    for (const ErrorScale::Tick &tick : m_scale.ticks(most))
        ticker->addTick(tick.axis, tick.label);
    plot()->yAxis->setTicker(ticker);
    plot()->yAxis->setRange(ErrorScale::bottom, m_scale.top());
    const QString unit = QString::fromUtf8(m_axis->unit);
    plot()->yAxis->setLabel(height() < lowHeight ? unit
                                                 : QStringLiteral("%1, %2").arg(
                                                     QString::fromUtf8(m_axis->title), unit));

    const auto reference = std::ranges::find_if(m_chart.points, [](const ParetoPoint &point) {
        return point.contender == QLatin1String(referenceContenderId);
    });
    QCPAxis *times = plot()->xAxis2;
    times->setVisible(reference != m_chart.points.end());
    if (times->visible()) {
        setLogRange(times, low / reference->cost.median, high / reference->cost.median,
                    QStringLiteral("×"));
        // Where the chart is low, the decades need the height of these words.
        times->setLabel(height() < lowHeight
                            ? QString()
                            : tr("times the assignment's method (column scan, float32)"));
    }
}

void ParetoPlot::addStaircase()
{
    QColor faint = palette().color(QPalette::Text);
    faint.setAlphaF(0.35F);
    auto *separator = new QCPItemStraightLine(plot());
    separator->setPen(QPen(faint, 1));
    separator->point1->setCoords(1, ErrorScale::separator);
    separator->point2->setCoords(2, ErrorScale::separator);

    faint.setAlphaF(0.6F);
    auto *stairs = new QCPCurve(plot()->xAxis, plot()->yAxis);
    stairs->setPen(QPen(faint, 1.5));
    stairs->setName(tr("frontier"));
    stairs->addToLegend();
    QVector<double> costs;
    QVector<double> errors;
    for (const StaircaseCorner &corner : m_chart.staircase()) {
        costs.append(corner.cost);
        errors.append(m_scale.toAxis(corner.errorClass, corner.error));
    }
    if (!costs.isEmpty()) {
        // Nobody is cheaper than the first, however wrong, nor more exact than the last.
        costs.prepend(costs.constFirst());
        errors.prepend(m_scale.top());
        costs.append(plot()->xAxis->range().upper);
        errors.append(errors.constLast());
    }
    stairs->setData(costs, errors);
}

void ParetoPlot::addPoint(const ParetoPoint &point)
{
    const double error = m_scale.toAxis(point.errorClass, point.error);
    const QColor colour = arithmeticColour(arithmeticOf(point), palette());
    auto *bar = new QCPItemLine(plot());
    bar->setPen(QPen(colour, 1));
    bar->setHead(QCPLineEnding(QCPLineEnding::esBar, 5));
    bar->setTail(QCPLineEnding(QCPLineEnding::esBar, 5));
    bar->start->setCoords(point.cost.lower, error);
    bar->end->setCoords(point.cost.upper, error);
    QCPGraph *dot = plot()->addGraph();
    dot->setLineStyle(QCPGraph::lsNone);
    dot->setScatterStyle(arithmeticDot(arithmeticOf(point), DotFill::Solid, palette()));
    dot->setData({point.cost.median}, {error}, true);
    const auto addRing = [&](const QPen &pen, double size) {
        QCPGraph *ring = plot()->addGraph();
        ring->setLineStyle(QCPGraph::lsNone);
        ring->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, pen, QBrush(Qt::NoBrush), size));
        ring->setData({point.cost.median}, {error}, true);
    };
    if (point.contender == m_selected)
        addRing(QPen(palette().color(QPalette::Highlight), 2.5), 19);
    if (point.missesStraight)
        addRing(missPen(), 15);
}

void ParetoPlot::addStraight(const ParetoPoint &point)
{
    if (!point.straight)
        return;
    const double error = m_scale.toAxis(point.errorClass, point.error);
    const Arithmetic arithmetic = arithmeticOf(point);
    auto *way = new QCPItemLine(plot());
    way->setPen(QPen(arithmeticColour(arithmetic, palette()), 1, Qt::DotLine));
    way->start->setCoords(point.straight->median, error);
    way->end->setCoords(point.cost.median, error);
    QCPGraph *dot = plot()->addGraph();
    dot->setLineStyle(QCPGraph::lsNone);
    dot->setScatterStyle(arithmeticDot(arithmetic, DotFill::Hollow, palette()));
    dot->setData({point.straight->median}, {error}, true);
}

/// The dots that matter most choose their labels' places first.
void ParetoPlot::addLabels()
{
    std::vector<const ParetoPoint *> points;
    for (const ParetoPoint &point : m_chart.points)
        points.push_back(&point);
    const auto rank = [this](const ParetoPoint *point) {
        return point->contender == m_selected                                                  ? 0
            : point->isOnFrontier                                                              ? 1
            : point->contender == QLatin1String(referenceContenderId) || point->missesStraight ? 2
                                                                                               : 3;
    };
    std::ranges::stable_sort(points, {}, rank);
    const QFontMetricsF metrics(smallFont());
    std::vector<LabelledDot> dots;
    QStringList texts;
    for (const ParetoPoint *point : points) {
        texts.append(pointLabel(*point));
        dots.push_back({placeOf(*point), metrics.size(Qt::TextSingleLine, texts.back())});
    }
    std::vector<QPointF> loops;
    for (const ParetoPoint *point : points) {
        if (point->straight)
            loops.emplace_back(plot()->xAxis->coordToPixel(point->straight->median),
                               placeOf(*point).y());
    }
    const auto places = placeLabels(dots, loops, QRectF(plot()->axisRect()->rect()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i])
            continue;
        auto *label = new QCPItemText(plot());
        label->setText(texts[qsizetype(i)]);
        label->setFont(smallFont());
        label->setColor(arithmeticColour(arithmeticOf(*points[i]), palette()));
        label->setPadding({});
        label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->position->setType(QCPItemPosition::ptAbsolute);
        label->position->setCoords(places[i]->topLeft());
    }
}

void ParetoPlot::addKeys()
{
    const auto hasAny
        = [this](const auto &test) { return std::ranges::any_of(m_chart.points, test); };
    for (const Arithmetic arithmetic : allArithmetics) {
        if (!hasAny([&](const ParetoPoint &point) { return arithmeticOf(point) == arithmetic; }))
            continue;
        QCPGraph *key = addKey(nameText(nameOf(arithmetic)));
        key->setLineStyle(QCPGraph::lsNone);
        key->setScatterStyle(arithmeticDot(arithmetic, DotFill::Solid, palette()));
    }
    if (hasAny([](const ParetoPoint &point) { return point.straight.has_value(); })) {
        QCPGraph *key = addKey(tr("straight loop"));
        key->setLineStyle(QCPGraph::lsNone);
        key->setScatterStyle(arithmeticDot(Arithmetic::Exact, DotFill::Hollow, palette()));
    }
    if (hasAny([](const ParetoPoint &point) { return point.missesStraight.has_value(); })) {
        QCPGraph *key = addKey(tr("over 1.3 × its loop"));
        key->setLineStyle(QCPGraph::lsNone);
        key->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, missPen(), QBrush(Qt::NoBrush), 12));
    }
}

} // namespace pixelplumb
