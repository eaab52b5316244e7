// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/driftplot.h"

#include "core/scan/choicenames.h"
#include "widgets/studies/precisionplot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double fencePixels = 0.5; ///< where a bound may cross a sample for certain

} // namespace

DriftPlot::DriftPlot(QWidget *parent)
    : LabPlot("labDrift", tr("Drift of increments over the columns"), parent)
{
}

void DriftPlot::show(const SharedResults &results)
{
    m_results = results;
    rebuild();
}

std::vector<QStringList> DriftPlot::numbers() const
{
    std::vector<QStringList> lines = {{QStringLiteral("arithmetic"), QStringLiteral("column"),
                                       QStringLiteral("error"), QStringLiteral("limit")}};
    for (const DriftCurve &curve : m_results ? m_results->drift : std::vector<DriftCurve>()) {
        for (const DriftPoint &point : curve.points)
            lines.push_back({nameText(nameOf(curve.arithmetic)), QString::number(point.column),
                             QString::number(point.error), QString::number(point.limit)});
    }
    return lines;
}

/// The error of each arithmetic at the column under the pointer.
QString DriftPlot::textAt(const QPointF &position) const
{
    if (!m_results || !plot()->axisRect()->rect().contains(position.toPoint()))
        return {};
    const auto column = std::int64_t(std::llround(plot()->xAxis->pixelToCoord(position.x())));
    QStringList lines;
    for (const DriftCurve &curve : m_results->drift) {
        const auto point = std::ranges::lower_bound(curve.points, column, {}, &DriftPoint::column);
        if (point == curve.points.end())
            continue;
        lines.append(tr("%1: %2 px, at most %3 px by proof")
                         .arg(nameText(nameOf(curve.arithmetic)),
                              QString::number(point->error, 'g', 3),
                              QString::number(point->limit, 'g', 3)));
    }
    if (lines.isEmpty())
        return {};
    lines.prepend(tr("<b>after %n columns</b>", nullptr, int(column)));
    return lines.join(QStringLiteral("<br>"));
}

void DriftPlot::build()
{
    plot()->xAxis->setLabel(tr("columns walked"));
    plot()->yAxis->setLabel(isLow() ? tr("px") : tr("error of a bound, px"));
    double smallest = fencePixels;
    double largest = fencePixels;
    std::int64_t last = 0;
    for (const DriftCurve &curve : m_results ? m_results->drift : std::vector<DriftCurve>()) {
        QCPGraph *error = addKey(nameText(nameOf(curve.arithmetic)));
        QColor colour = arithmeticColour(curve.arithmetic, palette());
        error->setPen(QPen(colour, 1.5, arithmeticLine(curve.arithmetic)));
        colour.setAlphaF(0.6F);
        QCPGraph *limit = plot()->addGraph();
        limit->setPen(QPen(colour, 1, Qt::DotLine));
        for (const DriftPoint &point : curve.points) {
            if (point.column < 1)
                continue;
            last = std::max(last, point.column);
            // An error of 0 is below every power of ten: a gap in the curve.
            error->addData(double(point.column), point.error > 0 ? point.error : qQNaN());
            if (point.error > 0)
                smallest = std::min(smallest, point.error);
            if (point.limit > 0) {
                limit->addData(double(point.column), point.limit);
                largest = std::max(largest, point.limit);
            }
        }
    }
    setLogRange(plot()->xAxis, 1, double(std::max<std::int64_t>(last, 10)));
    setLogRange(plot()->yAxis, smallest / 2, largest * 2);
    if (last == 0)
        return addMessage(tr("Drift is computed at the end of a study."));
    QCPGraph *limitKey = addKey(tr("limit by proof"),
                                tr("No error of this arithmetic can be larger: its curve stays "
                                   "below the dotted one of its colour."));
    limitKey->setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
    QCPGraph *fence
        = addKey(tr("½ px"), tr("From here on a bound is off by half a pixel and more."));
    fence->setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    fence->setData({1.0, double(last)}, {fencePixels, fencePixels}, true);
}

} // namespace pixelplumb
