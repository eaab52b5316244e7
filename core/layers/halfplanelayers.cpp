// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/clippedline.h"
#include "core/layers/edgelinenumbers.h"
#include "core/layers/layers.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pixelplumb {

namespace {

constexpr double leastNormal = 2; ///< px
constexpr double normalOfEdge = 0.25; ///< of the edge's length
// Logical pixels.
constexpr double roomBesideEdge = 300; ///< of an edge so long; names beside a shorter one crowd
constexpr double nameBeyondEdge = 96; ///< from a short edge's end to its name

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

/// On an edge's line beyond one of its ends, where the triangle is not; in view if the end is.
QPointF placeBeyond(const QPointF &end, const QPointF &otherEnd, const LayerMoment &moment)
{
    const QPointF along = end - otherEnd;
    const double beyond = nameBeyondEdge / moment.view.cell;
    const QLineF way(end, end + along / std::hypot(along.x(), along.y()) * beyond);
    const SampleBox seen = moment.seen();
    const std::optional<QLineF> inView
        = clipped(way,
                  QRectF(QPointF(double(seen.firstX), double(seen.firstY)),
                         QPointF(double(seen.endX), double(seen.endY))));
    return inView ? inView->p2() : way.p2();
}

/// From the middle of the edge to its positive side; a point where the edge is one.
QLineF arrowOf(const EdgeLineNumbers &line)
{
    const QPointF normal(line.a.toDouble(), line.b.toDouble());
    const QPointF along = line.to - line.from;
    const double length = std::max(leastNormal, std::hypot(along.x(), along.y()) * normalOfEdge);
    const QPointF unit = normal.isNull() ? QPointF() : normal / std::hypot(normal.x(), normal.y());
    const QPointF middle = line.from + along / 2;
    return {middle, middle + unit * length};
}

/// Each in its own half-plane, and not beside the arrow of another one.
void appendNames(const EdgeLineNumbers &line, const QLineF &arrow, std::vector<QLineF> otherArrows,
                 const LayerMoment &moment, LayerDrawing &drawing)
{
    // As the slides write it: DejaVu's ⟨ ⟩ look like ( ) in small type.
    const QString name = QStringLiteral("%1 > 0, normal <%2, %3>")
                             .arg(line.name, cellNumber(line.a), cellNumber(line.b));
    const QPointF along = line.to - line.from;
    const QPointF inward = arrow.p2() - arrow.p1();
    const LayerDrawing::HalfPlane positive{arrow.p1(), inward};
    const QPointF beyondTo = placeBeyond(line.to, line.from, moment);
    const QPointF beyondFrom = placeBeyond(line.from, line.to, moment);
    if (std::hypot(along.x(), along.y()) * moment.view.cell < roomBesideEdge) {
        drawing.labels.push_back({name,
                                  beyondTo,
                                  LayerInk::Mark,
                                  positive,
                                  {beyondFrom, arrow.p2()},
                                  std::move(otherArrows)});
        return;
    }
    drawing.labels.push_back({name,
                              arrow.p2(),
                              LayerInk::Mark,
                              positive,
                              {arrow.center(), arrow.p1(), beyondTo, beyondFrom},
                              std::move(otherArrows)});
    drawing.labels.push_back({QStringLiteral("%1 < 0").arg(line.name), arrow.p1() - inward / 2,
                              LayerInk::Negative, LayerDrawing::HalfPlane{arrow.p1(), -inward}});
}

void appendHalfPlane(const EdgeLineNumbers &line, const QLineF &arrow, const LayerMoment &moment,
                     LayerDrawing &drawing)
{
    const FrameSpec &frame = moment.frame();
    if (std::vector<QPointF> corners = positiveSide(line, frame); !corners.empty())
        drawing.areas.push_back({std::move(corners), LayerInk::Inside});
    const QPointF along = line.to - line.from;
    const QPointF middle = arrow.p1();
    // Far enough for the line to cross the frame.
    const QPointF beyond = along / std::hypot(along.x(), along.y())
        * (double(frame.width) + frame.height
           + std::hypot(middle.x() - frame.firstColumn, middle.y() - frame.firstRow));
    drawing.lines.push_back(
        {middle - beyond, middle + beyond, LayerInk::Mark, LayerDrawing::Stroke::Dashed});
    drawing.lines.push_back({arrow.p1(), arrow.p2(), LayerInk::Mark, LayerDrawing::Stroke::Arrow});
}

void appendHalfPlanes(const LayerMoment &moment, std::size_t first, std::size_t end,
                      LayerDrawing &drawing)
{
    const EdgeLines edges = edgeLinesOf(moment);
    std::vector<QLineF> arrows;
    std::ranges::transform(edges.lines, std::back_inserter(arrows), arrowOf);
    for (std::size_t line = first; line < end; ++line) {
        if (!arrows[line].isNull()) // else the edge is a point
            appendHalfPlane(edges.lines[line], arrows[line], moment, drawing);
    }
    for (std::size_t line = first; line < end; ++line) {
        std::vector<QLineF> others = arrows;
        others.erase(others.begin() + std::ptrdiff_t(line));
        if (!arrows[line].isNull())
            appendNames(edges.lines[line], arrows[line], std::move(others), moment, drawing);
    }
    if (edges.origin == NumberOrigin::Exact)
        drawing.notes.append(
            QStringLiteral("Half-planes: exact, since “%1” computes no edge functions")
                .arg(moment.view.traced->method->title));
}

template <std::size_t edge>
Layer halfPlaneLayer()
{
    return {.id = QStringLiteral("half-plane-%1").arg(edge),
            .title = QStringLiteral("Half-plane of E") + QChar(char16_t(u'₀' + edge)),
            .toolTip = QStringLiteral("Where the edge function of the edge %1–%2 is positive "
                                      "(tinted); of barycentric methods that of %3.")
                           .arg(edge)
                           .arg((edge + 1) % 3)
                           .arg(QStringList({QStringLiteral("bc"), QStringLiteral("ca"),
                                             QStringLiteral("ab")})[qsizetype(edge)]),
            .source = QStringLiteral("Rasterization slides, “Edge Equations”"),
            .kinds = {PrimitiveKind::Triangle},
            .draw = [](const LayerMoment &moment, LayerDrawing &drawing) {
                appendHalfPlanes(moment, edge, edge + 1, drawing);
            }};
}

} // namespace

Layer halfPlanesLayer()
{
    return {.id = QStringLiteral("half-planes"),
            .title = QStringLiteral("Half-planes and normals"),
            .toolTip = QStringLiteral(
                "Where each edge function A·x + B·y + C is positive (tinted, the inside thrice) "
                "and its normal ⟨A, B⟩: the numbers of the set-up; exact ones where the method "
                "has none."),
            .source = QStringLiteral(
                "Triangle Rasterization slides, “Edge sidedness”; Rasterization slides, “Edge "
                "Equations”; Scan Conversion slides, “Implicit Equation for a 2D line”"),
            .kinds = {PrimitiveKind::Triangle},
            .draw = [](const LayerMoment &moment, LayerDrawing &drawing) {
                appendHalfPlanes(moment, 0, 3, drawing);
            }};
}

Layer halfPlane0Layer() { return halfPlaneLayer<0>(); }
Layer halfPlane1Layer() { return halfPlaneLayer<1>(); }
Layer halfPlane2Layer() { return halfPlaneLayer<2>(); }

} // namespace pixelplumb
