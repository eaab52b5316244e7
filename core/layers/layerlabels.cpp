// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerlabels.h"

#include "core/layers/clippedline.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double labelEm = 12;
constexpr std::array labelGaps = {6.0, 20.0, 36.0, 54.0, 76.0}; ///< from the anchor, to each side
constexpr std::array barGaps = {2.0, 16.0, 32.0, 50.0, 72.0}; ///< from a bar to its text
constexpr double beyondMeasured = 16; ///< added on the side of what the bar measures
constexpr double sameDistance = 1e-6;
constexpr double barSeparation = 1; ///< from a bar's text to the end where another bar continues
constexpr double leaderGap = 8; ///< a label farther than this from its anchor has a line to it
constexpr double paperPadding = 3;
constexpr double nearView = 20; ///< names of what is farther out would crowd the border

/// Places for a label beside its anchor, nearest first: right above it, in the other quadrants,
/// then farther and farther away.
std::vector<QPointF> placesAround(const QPointF &anchor, const QSizeF &size)
{
    std::vector<QPointF> places;
    const double middle = anchor.x() - size.width() / 2;
    const double level = anchor.y() - size.height() / 2;
    for (const double gap : labelGaps) {
        const double right = anchor.x() + gap;
        const double left = anchor.x() - gap - size.width();
        const double above = anchor.y() - gap - size.height();
        const double below = anchor.y() + gap;
        places.insert(places.end(), {{right, above}, {right, below}, {left, above}, {left, below}});
        if (gap > leaderGap)
            places.insert(places.end(),
                          {{middle, above}, {middle, below}, {right, level}, {left, level}});
    }
    return places;
}

/// The distance between two rectangles; 0 if they meet.
double distanceOf(const QRectF &a, const QRectF &b)
{
    return std::hypot(std::max({0.0, a.left() - b.right(), b.left() - a.right()}),
                      std::max({0.0, a.top() - b.bottom(), b.top() - a.bottom()}));
}

/// The distance of a point from a line segment.
double distanceOf(const QPointF &point, const QLineF &line)
{
    const QPointF along = line.p2() - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double part = square > 0 ? QPointF::dotProduct(point - line.p1(), along) / square : 0;
    return QLineF(point, line.p1() + std::clamp(part, 0.0, 1.0) * along).length();
}

/// The distance between a rectangle and a line; 0 if they meet.
double distanceOf(const QRectF &rect, const QLineF &line)
{
    if (clipped(line, rect))
        return 0;
    double least = std::min(distanceOf(rect, QRectF(line.p1(), QSizeF())),
                            distanceOf(rect, QRectF(line.p2(), QSizeF())));
    for (const QPointF &corner :
         {rect.topLeft(), rect.topRight(), rect.bottomLeft(), rect.bottomRight()})
        least = std::min(least, distanceOf(corner, line));
    return least;
}

/// Where along an axis the text of a bar begins: in the middle of the bar, but not beyond the end
/// at which another bar continues.
double besideStart(double first, double last, double length, double otherMiddle)
{
    const double middle = (first + last - length) / 2;
    return otherMiddle < (first + last) / 2 ? std::max(middle, first + barSeparation)
                                            : std::min(middle, last - barSeparation - length);
}

/// Places for the text of a bar, nearest first: on the side that `away` points to, then beyond what
/// the bar measures, then farther away.
std::vector<QRectF> placesBeside(const QRectF &bar, const QPointF &away,
                                 std::span<const QRectF> otherBars, const QSizeF &size)
{
    const bool isUpright = std::abs(away.x()) > std::abs(away.y());
    const QPointF other = otherBars.empty() ? bar.center() : otherBars.front().center();
    const double x = besideStart(bar.left(), bar.right(), size.width(), other.x());
    const double y = besideStart(bar.top(), bar.bottom(), size.height(), other.y());
    std::vector<QRectF> places;
    const auto addPlace = [&](double sign, double gap) {
        const double right = sign > 0 ? bar.right() + gap : bar.left() - gap - size.width();
        const double below = sign > 0 ? bar.bottom() + gap : bar.top() - gap - size.height();
        places.push_back({isUpright ? QPointF(right, y) : QPointF(x, below), size});
    };
    const double sign = isUpright ? away.x() : away.y();
    for (const double gap : barGaps) {
        addPlace(sign, gap);
        addPlace(-sign, gap + beyondMeasured);
    }
    return places;
}

/// Kept in view, so that a name near the border can be read.
QRectF movedInto(QRectF rect, const QRectF &view)
{
    rect.moveLeft(std::max(std::min(rect.left(), view.right() - rect.width()), view.left()));
    rect.moveTop(std::max(std::min(rect.top(), view.bottom() - rect.height()), view.top()));
    return rect;
}

/// From an anchor to the nearest point of a label; a point if they are adjacent.
QLineF leaderTo(const QRectF &rect, const QPointF &anchor)
{
    const QLineF leader(anchor,
                        {std::clamp(anchor.x(), rect.left(), rect.right()),
                         std::clamp(anchor.y(), rect.top(), rect.bottom())});
    return leader.length() > leaderGap * std::sqrt(2.0) ? leader : QLineF(anchor, anchor);
}

bool strikes(const QLineF &leader, const QRectF &rect)
{
    return leader.length() > 0 && clipped(leader, rect);
}

} // namespace

bool LayerLabels::isFree(const QRectF &rect) const
{
    const auto covers = [&rect](const QRectF &other) { return other.intersects(rect); };
    return std::ranges::none_of(m_taken, covers)
        && std::ranges::none_of(m_placed, covers, &Placed::rect);
}

bool LayerLabels::isUnstruck(const Placed &label) const
{
    const auto strikesTaken = [&label](const QRectF &other) {
        // The line may begin at a handle that the name is about.
        return !other.contains(label.leader.p1()) && strikes(label.leader, other);
    };
    return std::ranges::none_of(m_taken, strikesTaken)
        && std::ranges::none_of(m_placed, [&label](const Placed &other) {
               return strikes(label.leader, other.rect) || strikes(other.leader, label.rect);
           });
}

void LayerLabels::place(const LayerDrawing::Label &label)
{
    std::vector<QPointF> anchors = {m_surface.fromSamples.map(label.place)};
    for (const QPointF &other : label.otherPlaces)
        anchors.push_back(m_surface.fromSamples.map(other));
    std::erase_if(anchors, [this](const QPointF &anchor) { return !isNearView(anchor); });
    const QSizeF size = sizeOf(label.text);
    std::vector<Placed> places;
    for (const QPointF &anchor : anchors) {
        for (const QPointF &corner : placesAround(anchor, size)) {
            const QRectF rect = movedInto({corner, size}, m_surface.view);
            if (isWithin(rect, label.side) && isFree(rect))
                places.push_back({label.text, rect, leaderTo(rect, anchor), label.ink});
        }
    }
    const auto isNearest = [&](const Placed &place) {
        const double own = distanceOf(place.rect, QRectF(place.leader.p1(), QSizeF()));
        return std::ranges::all_of(label.rivals, [&](const QLineF &rival) {
            return distanceOf(place.rect, m_surface.fromSamples.map(rival)) > own;
        });
    };
    const auto isClear = [&](const Placed &place) { return isNearest(place) && isUnstruck(place); };
    auto found = std::ranges::find_if(places, isClear);
    if (found == places.end())
        found = std::ranges::find_if(places, isNearest);
    if (found == places.end())
        found = std::ranges::find_if(places,
                                     [this](const Placed &place) { return isUnstruck(place); });
    if (found == places.end())
        found = places.begin();
    if (found != places.end())
        m_placed.push_back(*found);
    m_omitted += found == places.end() && !anchors.empty() ? 1 : 0;
}

void LayerLabels::placeBeside(const QString &text, const QRectF &bar, const QPointF &away,
                              std::span<const QRectF> otherBars, LayerInk ink)
{
    if (!isNearView(bar.center()))
        return;
    std::vector<QRectF> rects;
    for (const QRectF &rect : placesBeside(bar, away, otherBars, sizeOf(text))) {
        const QRectF inView = movedInto(rect, m_surface.view);
        const double own = distanceOf(inView, bar);
        if (std::ranges::all_of(otherBars, [&](const QRectF &other) {
                return distanceOf(inView, other) > own - sameDistance;
            }))
            rects.push_back(inView);
    }
    if (!placeAt(text, bar.center(), ink, rects))
        ++m_omitted;
}

bool LayerLabels::isNearView(const QPointF &anchor) const
{
    return m_surface.view.adjusted(-nearView, -nearView, nearView, nearView).contains(anchor);
}

bool LayerLabels::isWithin(const QRectF &rect,
                           const std::optional<LayerDrawing::HalfPlane> &side) const
{
    if (!side)
        return true;
    // Right angles stay right: samples are mapped to the view by one scale, flipped at most.
    const QPointF border = m_surface.fromSamples.map(side->onBorder);
    const QPointF inward = m_surface.fromSamples.map(side->onBorder + side->inward) - border;
    const auto isInward
        = [&](const QPointF &corner) { return QPointF::dotProduct(corner - border, inward) >= 0; };
    return std::ranges::all_of(
        std::array{rect.topLeft(), rect.topRight(), rect.bottomLeft(), rect.bottomRight()},
        isInward);
}

QSizeF LayerLabels::sizeOf(const QString &text)
{
    return {m_glyphs.widthOf(text) * labelEm + 2 * paperPadding, lineHeight * labelEm + 2};
}

bool LayerLabels::placeAt(const QString &text, const QPointF &anchor, LayerInk ink,
                          std::span<const QRectF> rects)
{
    std::optional<Placed> found;
    for (const QRectF &rect : rects) {
        const Placed label{text, rect, leaderTo(rect, anchor), ink};
        if (!isFree(rect))
            continue;
        const bool isBest = isUnstruck(label);
        if (isBest || !found)
            found = label;
        if (isBest)
            break;
    }
    if (found)
        m_placed.push_back(*found);
    return found.has_value();
}

void LayerLabels::paint()
{
    for (const Placed &label : m_placed)
        paintLeader(label);
    LayerTexts texts(m_painter, m_surface, m_glyphs);
    for (const Placed &label : m_placed) {
        texts.paintPaper(label.rect);
        texts.paintText(label.text,
                        label.rect.topLeft() + QPointF(paperPadding, 1 + ascent * labelEm), labelEm,
                        label.ink);
    }
}

std::vector<QRectF> LayerLabels::places() const
{
    std::vector<QRectF> rects;
    for (const Placed &label : m_placed)
        rects.push_back(label.rect);
    return rects;
}

void LayerLabels::paintLeader(const Placed &label)
{
    if (label.leader.length() == 0)
        return;
    m_painter.setPen(QPen(paperOf(m_surface.tone), 3, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(label.leader);
    m_painter.setPen(QPen(colourOf(label.ink, m_surface.tone), 1, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(label.leader);
}

} // namespace pixelplumb
