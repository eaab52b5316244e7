// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labelplaces.h"

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

} // namespace

namespace {

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

} // namespace pixelplumb
