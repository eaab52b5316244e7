// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/scalingplot.h"

#include "widgets/lab/labmarks.h"
#include "widgets/lab/labtext.h"
#include "widgets/studies/precisionplot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double scalingReach = 10; ///< logical pixels from a point to a pointer that means it

QString sizeText(SizeAxis axis)
{
    switch (axis) {
    case SizeAxis::Width:
        return ScalingPlot::tr("width of one triangle of constant height, px");
    case SizeAxis::Area:
        return ScalingPlot::tr("area of one triangle of constant shape, px");
    case SizeAxis::Triangles:
        return ScalingPlot::tr("triangles of constant size");
    }
    return {};
}

Arithmetic arithmeticOfCurve(const SizeCurve &curve)
{
    const std::optional<LabContender> contender = labContenderNamed(curve.contender);
    return contender ? contender->arithmetic : Arithmetic::Exact;
}

QString methodOfCurve(const SizeCurve &curve) { return curve.contender.section(u':', 0, 0); }

} // namespace

ScalingPlot::ScalingPlot(QWidget *parent)
    : LabPlot("labScaling", tr("Times over sizes"), parent)
{
}

void ScalingPlot::show(const SharedResults &results, SizeAxis axis)
{
    m_results = results;
    m_axis = axis;
    rebuild();
}

/// The column scan has dots; its arithmetics are shared by other methods, which have crosses.
QCPScatterStyle ScalingPlot::markOf(const SizeCurve &curve) const
{
    const Arithmetic arithmetic = arithmeticOfCurve(curve);
    QStringList others;
    for (const SizeCurve &each : m_results->growth) {
        if (const QString method = methodOfCurve(each); !others.contains(method))
            others.append(method);
    }
    others.removeOne(QStringLiteral("column-scan"));
    const qsizetype other = others.indexOf(methodOfCurve(curve));
    return other < 0 ? kernelDot(arithmetic, kernelOf(curve.contender), palette())
                     : otherMethodDot(arithmetic, std::size_t(other), palette());
}

QString ScalingPlot::labelOf(const SizeCurve &curve) const
{
    const std::optional<LabContender> contender = labContenderNamed(curve.contender);
    const QString label = contender ? contender->label : curve.contender;
    return curve.exponent ? tr("%1  ~ n^%2").arg(label, QString::number(*curve.exponent, 'f', 2))
                          : label;
}

void ScalingPlot::build()
{
    plot()->xAxis->setLabel(sizeText(m_axis));
    plot()->yAxis->setLabel(isLow() ? tr("µs") : tr("a draw, µs"));
    double least = 0;
    double most = 0;
    double shortest = 0;
    double longest = 0;
    const auto extend = [](double value, double &low, double &high) {
        low = low > 0 ? std::min(low, value) : value;
        high = std::max(high, value);
    };
    for (const SizeCurve &curve : m_results ? m_results->growth : std::vector<SizeCurve>()) {
        if (curve.axis != m_axis)
            continue;
        QCPGraph *graph
            = addKey(labelOf(curve),
                     tr("n^1 doubles its time where the size doubles, n^0 does not grow: the "
                        "exponent is fitted to the larger half of the sizes."));
        const Arithmetic arithmetic = arithmeticOfCurve(curve);
        graph->setPen(
            QPen(arithmeticColour(arithmetic, palette()), 1.5, arithmeticLine(arithmetic)));
        graph->setScatterStyle(markOf(curve));
        for (const SizePoint &point : curve.points) {
            if (point.size <= 0 || point.perDraw.median <= 0)
                continue;
            graph->addData(point.size, point.perDraw.median / 1000);
            extend(point.size, least, most);
            extend(point.perDraw.median / 1000, shortest, longest);
        }
    }
    if (least <= 0) {
        setLogRange(plot()->xAxis, 1, 1000);
        setLogRange(plot()->yAxis, 1, 1000);
        return addMessage(tr("How times grow is measured at the end of a study."));
    }
    setLogRange(plot()->xAxis, least / 1.3, most * 1.3);
    setLogRange(plot()->yAxis, shortest / 1.5, longest * 1.5);
}

QString ScalingPlot::figureTitle() const
{
    return tr("%1: %2").arg(accessibleName(), sizeText(m_axis));
}

std::vector<QStringList> ScalingPlot::numbers() const
{
    std::vector<QStringList> lines
        = {{QStringLiteral("contender"), QStringLiteral("axis"), QStringLiteral("size"),
            QStringLiteral("nsADrawLower"), QStringLiteral("nsADraw"),
            QStringLiteral("nsADrawUpper"), QStringLiteral("exponent")}};
    for (const SizeCurve &curve : m_results ? m_results->growth : std::vector<SizeCurve>()) {
        for (const SizePoint &point : curve.points)
            lines.push_back({curve.contender, nameOf(curve.axis), QString::number(point.size),
                             QString::number(point.perDraw.lower),
                             QString::number(point.perDraw.median),
                             QString::number(point.perDraw.upper),
                             curve.exponent ? QString::number(*curve.exponent) : QString()});
    }
    return lines;
}

QString ScalingPlot::textAt(const QPointF &position) const
{
    if (!m_results)
        return {};
    for (const SizeCurve &curve : m_results->growth) {
        if (curve.axis != m_axis)
            continue;
        for (const SizePoint &point : curve.points) {
            const double x = plot()->xAxis->coordToPixel(point.size);
            const double y = plot()->yAxis->coordToPixel(point.perDraw.median / 1000);
            if (std::hypot(x - position.x(), y - position.y()) > scalingReach)
                continue;
            const Spread micro = {point.perDraw.lower / 1000, point.perDraw.median / 1000,
                                  point.perDraw.upper / 1000};
            return QStringLiteral("<b>%1</b><br>%2")
                .arg(labelOf(curve).toHtmlEscaped(),
                     tr("n = %1: %2 µs").arg(figureText(point.size), spreadText(micro)));
        }
    }
    return {};
}

} // namespace pixelplumb
