// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labtext.h"
#include "widgets/lab/paretoplot.h"
#include "widgets/studies/precisionplot.h"

#include <qcustomplot.h>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr double lineMargin = 2; ///< logical pixels between a label and a line
constexpr double tickLength = 6; ///< of an axis, inwards
constexpr float seenThrough = 0.7F; ///< opacity of a label over a line that it must cross

} // namespace

LabelArea ParetoPlot::labelArea() const
{
    LabelArea area;
    const QRectF axes(plot()->axisRect()->rect());
    area.whole = axes.adjusted(0, 0, 0, -tickLength);
    area.sides = isLow() ? LabelArea::Sides::Beside : LabelArea::Sides::All;
    const auto addLine = [&area](const QPointF &from, const QPointF &to) {
        area.lines.push_back(QRectF(from, to).normalized().adjusted(-lineMargin, -lineMargin,
                                                                    lineMargin, lineMargin));
    };
    for (const Dot &dot : m_dots) {
        if (!dot.point.straight)
            continue;
        const QPointF loop(plot()->xAxis->coordToPixel(dot.point.straight->median),
                           placeOf(dot).y());
        area.others.push_back(coveredBy(loop));
        addLine(loop, placeOf(dot));
    }
    for (const LabKernel kernel : ownLabKernels) {
        QPointF before;
        for (const StaircaseCorner &corner : m_chart.staircase(kernel)) {
            const QPointF here(
                plot()->xAxis->coordToPixel(corner.cost),
                plot()->yAxis->coordToPixel(m_scale.toAxis(corner.errorClass, corner.error)));
            addLine(before.isNull() ? QPointF(here.x(), axes.top() - 1) : before, here);
            before = here;
        }
        if (!before.isNull())
            addLine(before, {axes.right(), before.y()});
    }
    return area;
}

/// Places the labels, those of the most important dots first; in a low chart the others have none.
void ParetoPlot::addLabels()
{
    const auto rank = [this](const Dot *dot) {
        const ParetoPoint &point = dot->point;
        if (point.contender == m_selected)
            return 0;
        if (point.isOnFrontier)
            return 1;
        return point.isReference() || point.missesStraight ? 2 : 3;
    };
    std::vector<const Dot *> dots;
    for (const Dot &dot : m_dots)
        dots.push_back(&dot);
    std::ranges::stable_sort(dots, {}, rank);
    const QFontMetricsF metrics(smallFont());
    std::vector<LabelledDot> labelled;
    for (const Dot *dot : dots) {
        const bool isSilent = isLow() && rank(dot) > 2;
        labelled.push_back(
            {placeOf(*dot),
             isSilent ? QSizeF() : metrics.size(Qt::TextSingleLine, pointLabel(dot->point))});
    }
    const auto places = placeLabels(labelled, labelArea());
    QColor behind = palette().color(QPalette::Base);
    behind.setAlphaF(seenThrough);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i])
            continue;
        auto *label = new QCPItemText(plot());
        label->setText(pointLabel(dots[i]->point));
        label->setFont(smallFont());
        label->setColor(arithmeticColour(arithmeticOf(dots[i]->point), palette()));
        label->setBrush(QBrush(behind));
        label->setPadding({});
        label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->position->setType(QCPItemPosition::ptAbsolute);
        label->position->setCoords(places[i]->topLeft());
    }
}

} // namespace pixelplumb
