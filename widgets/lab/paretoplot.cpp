// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/paretoplot.h"

#include "core/scan/choicenames.h"
#include "widgets/lab/labtext.h"
#include "widgets/studies/accuracy/precisionscale.h"

#include <QtWidgets>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double reach = 12; ///< logical pixels from a dot within which the pointer hits it

} // namespace

ErrorScale::ErrorScale(const ParetoChart &chart)
{
    std::vector<ParetoPoint> points = chart.points;
    points.insert(points.end(), chart.untimed.begin(), chart.untimed.end());
    m_hasTested = std::ranges::find(points, ErrorClass::ZeroTested, &ParetoPoint::errorClass)
        != points.end();
    double smallest = 0;
    double largest = 0;
    for (const ParetoPoint &point : points) {
        if (point.errorClass != ErrorClass::Positive || !std::isfinite(point.error))
            continue;
        smallest = smallest > 0 ? std::min(smallest, point.error) : point.error;
        largest = std::max(largest, point.error);
    }
    if (smallest <= 0)
        return;
    m_least = int(std::floor(std::log10(smallest)));
    m_largest = std::max(int(std::ceil(std::log10(largest))), m_least + 1);
}

double ErrorScale::toAxis(ErrorClass errorClass, double error) const
{
    switch (errorClass) {
    case ErrorClass::ZeroProved:
        return provedRow;
    case ErrorClass::ZeroTested:
        return testedRow();
    case ErrorClass::ZeroObserved:
        return observedRow();
    case ErrorClass::Positive:
        break;
    }
    // An infinite error is at the upper end.
    return std::min(decades() + std::log10(error) - m_least, top());
}

ErrorClass ErrorScale::classAt(double axis) const
{
    if (axis >= separator())
        return ErrorClass::Positive;
    if (axis >= observedRow() - betweenRows / 2)
        return ErrorClass::ZeroObserved;
    return m_hasTested && axis >= testedRow() - betweenRows / 2 ? ErrorClass::ZeroTested
                                                                : ErrorClass::ZeroProved;
}

std::vector<ErrorScale::Tick> ErrorScale::ticks(int most) const
{
    std::vector<Tick> ticks
        = {{provedRow, QCoreApplication::translate("pixelplumb::ErrorScale", "0, proved")},
           {observedRow(), QCoreApplication::translate("pixelplumb::ErrorScale", "0, observed")}};
    if (m_hasTested)
        ticks.push_back(
            {testedRow(), QCoreApplication::translate("pixelplumb::ErrorScale", "0, tested")});
    const int stride = std::max(1, (m_largest - m_least + most) / std::max(1, most));
    for (int exponent = m_largest; exponent >= m_least; exponent -= stride)
        ticks.push_back({decades() + exponent - m_least, powerOfTenText(exponent)});
    return ticks;
}

ParetoPlot::ParetoPlot(QWidget *parent)
    : LabPlot("labPareto", tr("Cost against error"), parent)
{
    setFocusPolicy(Qt::StrongFocus);
}

void ParetoPlot::show(const SharedResults &results, const QString &family, const ErrorAxis &axis)
{
    m_results = results;
    m_family = family;
    m_axis = &axis;
    m_chart = results ? paretoOf(*results, family, axis) : ParetoChart();
    m_scale = ErrorScale(m_chart);
    m_dots.clear();
    for (const ParetoPoint &point : m_chart.points)
        m_dots.push_back(
            {point, point.cost.median, m_scale.toAxis(point.errorClass, point.error), true});
    std::ranges::stable_sort(m_dots, {}, &Dot::cost);
    for (const ParetoPoint &point : m_chart.untimed)
        m_dots.push_back({point, 0, m_scale.toAxis(point.errorClass, point.error), false});
    rebuild();
}

void ParetoPlot::select(const QString &contender)
{
    if (contender == m_selected)
        return;
    m_selected = contender;
    const Dot *dot = dotOf(contender);
    setAccessibleDescription(dot ? plainText(textOf(*dot)) : QString());
    rebuild();
}

Arithmetic ParetoPlot::arithmeticOf(const ParetoPoint &point) const
{
    const LabRow *row = m_results->row(point.contender, m_family);
    return row ? row->settings.arithmetic : Arithmetic::Exact;
}

QPointF ParetoPlot::placeOf(const Dot &dot) const
{
    return {plot()->xAxis->coordToPixel(dot.cost), plot()->yAxis->coordToPixel(dot.error)};
}

const ParetoPlot::Dot *ParetoPlot::dotOf(const QString &contender) const
{
    const auto dot = std::ranges::find_if(
        m_dots, [&](const Dot &each) { return each.point.contender == contender; });
    return dot == m_dots.end() ? nullptr : &*dot;
}

std::optional<QPointF> ParetoPlot::positionOf(const QString &contender) const
{
    const Dot *dot = dotOf(contender);
    return dot ? std::optional<QPointF>(plot()->mapTo(this, placeOf(*dot))) : std::nullopt;
}

const ParetoPlot::Dot *ParetoPlot::dotAt(const QPointF &position) const
{
    const Dot *nearest = nullptr;
    double least = reach;
    for (const Dot &dot : m_dots) {
        const QPointF way = placeOf(dot) - position;
        if (const double distance = std::hypot(way.x(), way.y()); distance <= least) {
            least = distance;
            nearest = &dot;
        }
    }
    return nearest;
}

QString ParetoPlot::textOf(const Dot &dot) const
{
    return dot.isTimed ? pointHtml(*m_results, dot.point, m_family)
                       : untimedHtml(*m_results, dot.point, m_family);
}

QString ParetoPlot::textAt(const QPointF &position) const
{
    if (const Dot *dot = dotAt(position))
        return textOf(*dot);
    const QRect axes = plot()->axisRect()->rect();
    if (!m_axis || position.x() >= axes.left() || position.y() < axes.top()
        || position.y() > axes.bottom())
        return {};
    return errorClassText(m_scale.classAt(plot()->yAxis->pixelToCoord(position.y())));
}

void ParetoPlot::clickAt(const QPointF &position)
{
    setFocus(Qt::MouseFocusReason);
    if (const Dot *dot = dotAt(position))
        emit contenderClicked(QString(dot->point.contender));
}

void ParetoPlot::keyPressEvent(QKeyEvent *event)
{
    const Dot *dot = dotOf(m_selected);
    const bool isForward = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down;
    const bool isBack = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up;
    if (dot && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
        emit contenderClicked(QString(dot->point.contender));
    } else if (!m_dots.empty() && (isForward || isBack)) {
        const auto count = int(m_dots.size());
        const int here = dot ? int(dot - m_dots.data()) : isForward ? -1 : count;
        const Dot &next
            = m_dots[std::size_t(std::clamp(here + (isForward ? 1 : -1), 0, count - 1))];
        emit contenderSelected(QString(next.point.contender));
        QToolTip::showText(plot()->mapToGlobal(placeOf(next).toPoint()), textOf(next), plot());
    } else {
        LabPlot::keyPressEvent(event);
    }
}

} // namespace pixelplumb
