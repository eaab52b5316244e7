// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labelplaces.h"

#include "widgets/lab/labtext.h"
#include "widgets/lab/paretoplot.h"
#include "widgets/look/signs.h"
#include "widgets/studies/accuracy/precisionplot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double dotRadius = 8; // including a ring
constexpr double gap = 3;

/// Candidates: right of the dot, left, above, below, and the four corners.
std::array<QPointF, 8> cornersFor(const LabelledDot &dot)
{
    const double right = dot.centre.x() + dotRadius + gap;
    const double left = dot.centre.x() - dotRadius - gap - dot.label.width();
    const double middleX = dot.centre.x() - dot.label.width() / 2;
    const double middleY = dot.centre.y() - dot.label.height() / 2;
    const double above = dot.centre.y() - dotRadius - dot.label.height();
    const double below = dot.centre.y() + dotRadius;
    return {QPointF(right, middleY), QPointF(left, middleY), QPointF(middleX, above),
            QPointF(middleX, below), QPointF(right, above),  QPointF(right, below),
            QPointF(left, above),    QPointF(left, below)};
}

constexpr double lineMargin = 2; ///< logical pixels between a label and a line
constexpr double tickLength = 6; ///< of an axis, inwards

} // namespace

QRectF coveredBy(const QPointF &dot)
{
    return {dot.x() - dotRadius, dot.y() - dotRadius, 2 * dotRadius, 2 * dotRadius};
}

namespace {

bool isCovered(const std::vector<QRectF> &places, const QRectF &candidate)
{
    return std::ranges::any_of(
        places, [&candidate](const QRectF &each) { return each.intersects(candidate); });
}

double distanceTo(const QRectF &label, const QPointF &dot)
{
    const double x = std::max({label.left() - dot.x(), 0.0, dot.x() - label.right()});
    const double y = std::max({label.top() - dot.y(), 0.0, dot.y() - label.bottom()});
    return std::hypot(x, y);
}

/// Whether the label seems to belong to another dot that is as near.
bool seemsAnothers(const QRectF &label, const LabelledDot &own,
                   const std::vector<LabelledDot> &dots)
{
    const double mine = distanceTo(label, own.centre);
    return std::ranges::any_of(dots, [&](const LabelledDot &dot) {
        return &dot != &own && distanceTo(label, dot.centre) <= mine + gap;
    });
}

} // namespace

std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelledDot> &dots,
                                               const LabelArea &area)
{
    std::vector<QRectF> taken = area.others;
    for (const LabelledDot &dot : dots)
        taken.push_back(coveredBy(dot.centre));
    std::vector<std::optional<QRectF>> places;
    for (const LabelledDot &dot : dots) {
        std::optional<QRectF> place;
        const auto corners = cornersFor(dot);
        const std::size_t choices = area.sides == LabelArea::Sides::Beside ? 2 : corners.size();
        for (std::size_t i = 0; i < choices && !dot.label.isEmpty(); ++i) {
            const QRectF candidate(corners[i], dot.label);
            if (!area.whole.contains(candidate) || isCovered(taken, candidate)
                || seemsAnothers(candidate, dot, dots))
                continue;
            const bool isFree = !isCovered(area.lines, candidate);
            if (isFree || !place)
                place = candidate;
            if (isFree)
                break;
        }
        if (place)
            taken.push_back(*place);
        places.push_back(place);
    }
    return places;
}

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
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i])
            continue;
        auto *label = new QCPItemText(plot());
        label->setText(pointLabel(dots[i]->point));
        label->setFont(smallFont());
        label->setColor(arithmeticColour(arithmeticOf(dots[i]->point), palette()));
        label->setBrush(palette().color(QPalette::Base)); // no line goes through it
        label->setPadding({});
        label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->position->setType(QCPItemPosition::ptAbsolute);
        label->position->setCoords(places[i]->topLeft());
    }
}

} // namespace pixelplumb
