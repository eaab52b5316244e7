// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/clippedline.h"
#include "core/layers/edgelinenumbers.h"
#include "core/layers/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pixelplumb {

namespace {

constexpr double leastNormal = 2; ///< px
constexpr double normalOfEdge = 0.25; ///< of the edge's length
// Logical pixels.
constexpr double roomBesideEdge = 300; ///< of an edge this long; names beside a shorter one crowd
constexpr double nameBeyondEdge = 96; ///< from a short edge's end to its name
constexpr double clearOfVertices = 32; ///< of a name beyond an edge: the lines meet at vertices

/// The part of the frame where an edge function is positive (Sutherland and Hodgman 1974).
std::vector<QPointF> positiveSide(const EdgeLineNumbers &line, const FrameSpec &frame)
{
    const double left = frame.firstColumn - 0.5;
    const double low = frame.firstRow - 0.5;
    const std::array<QPointF, 4> corners
        = {QPointF(left, low), QPointF(left + frame.width, low),
           QPointF(left + frame.width, low + frame.height), QPointF(left, low + frame.height)};
    std::vector<QPointF> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const QPointF &from = corners[i];
        const QPointF &to = corners[(i + 1) % corners.size()];
        const double fromValue = line.valueAt(from);
        const double toValue = line.valueAt(to);
        if (fromValue >= 0)
            kept.push_back(from);
        if ((fromValue < 0) != (toValue < 0))
            kept.push_back(from + (to - from) * (fromValue / (fromValue - toValue)));
    }
    return kept.size() < 3 ? std::vector<QPointF>() : kept;
}

/// An edge's line, long enough to cross the frame.
QLineF endlessLine(const EdgeLineNumbers &line, const FrameSpec &frame)
{
    const QPointF along = line.to - line.from;
    const QPointF middle = line.from + along / 2;
    const QPointF beyond = along / std::hypot(along.x(), along.y())
        * (double(frame.width) + frame.height
           + std::hypot(middle.x() - frame.firstColumn, middle.y() - frame.firstRow));
    return {middle - beyond, middle + beyond};
}

/// The visible part of an edge, or else of its line; the edge if nothing is visible.
QLineF seenOf(const EdgeLineNumbers &line, const LayerMoment &moment)
{
    const QLineF edge(line.from, line.to);
    if (const std::optional<QLineF> seen = clipped(edge, moment.seenArea());
        seen && !seen->isNull())
        return *seen;
    return clipped(endlessLine(line, moment.frame()), moment.seenArea()).value_or(edge);
}

/// Places on an edge's line beyond its ends, away from the triangle and from other lines: at both
/// ends, at one or nowhere.
std::vector<QPointF> placesBeyond(const EdgeLineNumbers &line, const QPointF &opposite,
                                  const LayerMoment &moment)
{
    const double cell = moment.view.cell;
    std::vector<QPointF> places;
    for (const auto &[end, other] :
         {std::pair(line.to, line.from), std::pair(line.from, line.to)}) {
        const QPointF along = end - other;
        const QLineF way(end,
                         end + along / std::hypot(along.x(), along.y()) * nameBeyondEdge / cell);
        const std::optional<QLineF> inView = clipped(way, moment.seenArea());
        if (inView && QLineF(end, inView->p2()).length() * cell >= clearOfVertices
            && QLineF(opposite, inView->p2()).length() * cell >= clearOfVertices)
            places.push_back(inView->p2());
    }
    return places;
}

/// From the middle of the visible edge to its positive side; a point if the edge is one.
QLineF arrowOf(const EdgeLineNumbers &line, const LayerMoment &moment)
{
    const QPointF normal(line.a.toDouble(), line.b.toDouble());
    if (line.from == line.to || normal.isNull())
        return {line.from, line.from};
    const QLineF seen = seenOf(line, moment);
    const double length = std::max(leastNormal, seen.length() * normalOfEdge);
    const QPointF inward = normal / std::hypot(normal.x(), normal.y()) * length;
    return {seen.center(), seen.center() + inward};
}

/// A triangle's edges, and what is drawn for each.
struct HalfPlanes {
    EdgeLines edges;
    std::array<QLineF, 3> arrows;

    explicit HalfPlanes(const LayerMoment &moment)
        : edges(edgeLinesOf(moment))
    {
        std::ranges::transform(edges.lines, arrows.begin(), [&moment](const EdgeLineNumbers &line) {
            return arrowOf(line, moment);
        });
    }

    /// The arrows and lines of the other edges.
    std::vector<QLineF> rivalsOf(std::size_t edge, const LayerMoment &moment) const
    {
        std::vector<QLineF> rivals;
        for (std::size_t other = 0; other < 3; ++other) {
            if (other == edge || arrows[other].isNull())
                continue;
            rivals.push_back(arrows[other]);
            rivals.push_back(endlessLine(edges.lines[other], moment.frame()));
        }
        return rivals;
    }
};

/// Places each name in its own half-plane, away from the arrow or the line of another edge.
void appendNames(const HalfPlanes &planes, std::size_t edge, const LayerMoment &moment,
                 LayerDrawing &drawing)
{
    const EdgeLineNumbers &line = planes.edges.lines[edge];
    const QLineF &arrow = planes.arrows[edge];
    const QPointF inward = arrow.p2() - arrow.p1();
    const QPointF &opposite = planes.edges.lines[(edge + 1) % 3].to;
    std::vector<QPointF> places = placesBeyond(line, opposite, moment);
    const double length = QLineF(line.from, line.to).length() * moment.view.cell;
    // Names inside a small triangle would crowd it.
    const std::array inside = {arrow.p2(), arrow.center(), arrow.p1()};
    places.insert(length < roomBesideEdge ? places.end() : places.begin(), inside.begin(),
                  inside.end());
    drawing.labels.push_back({u"%1 < 0"_s.arg(line.name),
                              arrow.p1() - inward / 2,
                              LayerInk::Negative,
                              LayerDrawing::HalfPlane{arrow.p1(), -inward},
                              {arrow.p1()},
                              planes.rivalsOf(edge, moment)});
    // As the slides write it: DejaVu's ⟨ ⟩ look like ( ) in small type.
    drawing.labels.push_back(
        {u"%1 > 0, normal <%2, %3>"_s.arg(line.name, preciseNumber(line.a), preciseNumber(line.b)),
         places.front(),
         LayerInk::Mark,
         LayerDrawing::HalfPlane{arrow.p1(), inward},
         {places.begin() + 1, places.end()},
         planes.rivalsOf(edge, moment)});
}

void appendHalfPlane(const EdgeLineNumbers &line, const QLineF &arrow, const LayerMoment &moment,
                     LayerDrawing &drawing)
{
    const FrameSpec &frame = moment.frame();
    if (std::vector<QPointF> corners = positiveSide(line, frame); !corners.empty())
        drawing.areas.push_back({std::move(corners), LayerInk::Inside});
    const QLineF endless = endlessLine(line, frame);
    drawing.lines.push_back(
        {endless.p1(), endless.p2(), LayerInk::Mark, LayerDrawing::Stroke::Dashed});
    drawing.lines.push_back({arrow.p1(), arrow.p2(), LayerInk::Mark, LayerDrawing::Stroke::Arrow});
}

void appendHalfPlanes(const LayerMoment &moment, std::size_t first, std::size_t end,
                      LayerDrawing &drawing)
{
    const HalfPlanes planes(moment);
    for (std::size_t edge = first; edge < end; ++edge) {
        if (!planes.arrows[edge].isNull()) // else the edge is a point
            appendHalfPlane(planes.edges.lines[edge], planes.arrows[edge], moment, drawing);
    }
    for (std::size_t edge = first; edge < end; ++edge) {
        if (!planes.arrows[edge].isNull())
            appendNames(planes, edge, moment, drawing);
    }
    if (planes.edges.origin == NumberOrigin::Exact)
        drawing.notes.append(u"Half-planes: exact, since “%1” computes no edge functions"_s.arg(
            moment.view.traced->method->title));
}

} // namespace

Layer halfPlaneLayer(std::size_t edge)
{
    return {.id = u"half-plane-%1"_s.arg(edge),
            .title = u"Half-plane of E"_s + QChar(char16_t(u'₀' + edge)),
            .toolTip = u"Where the edge function of the edge %1–%2 is positive "
                       "(tinted); of barycentric methods that of %3."_s.arg(edge)
                           .arg((edge + 1) % 3)
                           .arg(QStringList({"bc", "ca", "ab"})[qsizetype(edge)]),
            .source = "Rasterization slides, “Edge Equations”",
            .kinds = {PrimitiveKind::Triangle},
            .draw = [edge](const LayerMoment &moment, LayerDrawing &drawing) {
                appendHalfPlanes(moment, edge, edge + 1, drawing);
            }};
}

Layer halfPlanesLayer()
{
    return {.id = "half-planes",
            .title = QT_TRANSLATE_NOOP("core", "Half-planes and normals"),
            .toolTip
            = "Where each edge function A·x + B·y + C is positive (tinted, the inside thrice) and "
              "its normal ⟨A, B⟩: the numbers of the set-up; exact ones where the method has none.",
            .source = "Triangle Rasterization slides, “Edge sidedness”; Rasterization slides, "
                      "“Edge Equations”; Scan Conversion slides, “Implicit Equation for a 2D line”",
            .kinds = {PrimitiveKind::Triangle},
            .draw = [](const LayerMoment &moment, LayerDrawing &drawing) {
                appendHalfPlanes(moment, 0, 3, drawing);
            }};
}

} // namespace pixelplumb
