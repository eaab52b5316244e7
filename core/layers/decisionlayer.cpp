// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layers.h"

namespace pixelplumb {

namespace {

QString named(const QString &name, const Quantity &number)
{
    return u"%1 = %2"_s.arg(name, cellNumber(number));
}

/// Of two pixels that lie across the line: the one with the lesser coordinate, or the other.
enum class Neighbour { Lesser, Greater };

/// Where it is on the screen.
QString sideOf(Neighbour which, SpanAxis axis, FrameOrigin origin)
{
    const bool isFirst = which == Neighbour::Lesser;
    if (axis == SpanAxis::Row)
        return isFirst ? u"left"_s : u"right"_s;
    return isFirst == (origin == FrameOrigin::BottomLeft) ? u"lower"_s : u"upper"_s;
}

/// Rasterization slides, "Bresenham's Line Algorithm (1/4)": the line between the pixel that stays
/// and the one across, d_lower and d_upper away. The slide's line rises by less than 45°; in the
/// other octants d_lower is still the distance to the pixel that stays, and the layer says so.
void drawLineDecision(const NamedNumbers &setUp, SpanAxis axis, const NamedNumbers &step,
                      FrameOrigin origin, LayerDrawing &drawing)
{
    const Quantity stays = step[u"y_k"_s];
    const Quantity line = step[u"y_line"_s];
    if (stays.isNone() || line.isNone())
        return; // no decision led to the first pixel
    const bool isSteep = axis == SpanAxis::Row;
    const double along = step[isSteep ? u"y"_s : u"x"_s].toDouble();
    // d_lower and d_upper add up to 1, towards the pixel across.
    const bool falls = setUp[u"y_1"_s].toDouble() < setUp[u"y_0"_s].toDouble();
    const auto at = [&](double distance) {
        return isSteep ? QPointF(distance, along) : QPointF(along, distance);
    };
    const QPointF onLine = at(line.toDouble());
    const QPointF stayer = at(stays.toDouble());
    const QPointF across = at(stays.toDouble() + (falls ? -1 : 1));
    // Below 0, if the line is not between the two, a distance is measured the other way.
    const auto wayOf = [&](const QPointF &from, const QPointF &to) {
        return from == to ? across - stayer : to - from;
    };
    const auto measured = [&](const QString &name) { return named(name, step[name]); };
    drawing.measures.push_back(
        {stayer, onLine, measured("d_lower"), LayerInk::First, wayOf(stayer, onLine)});
    drawing.measures.push_back(
        {onLine, across, measured("d_upper"), LayerInk::Second, wayOf(onLine, across)});
    drawing.points.push_back({stayer, LayerInk::First});
    drawing.points.push_back({across, LayerInk::Second});
    drawing.points.push_back({onLine, LayerInk::Hand});
    drawing.labels.push_back({measured("p_k"), onLine, LayerInk::Hand});
    const QString side = sideOf(falls ? Neighbour::Greater : Neighbour::Lesser, axis, origin);
    if (side != u"lower"_s)
        drawing.notes.append(
            u"The letters are the slide's, whose line rises by less than 45°: “lower” is the "
            "distance to the pixel that stays, here the %1 one, “upper” that to the %2 one"_s.arg(
                side, sideOf(falls ? Neighbour::Lesser : Neighbour::Greater, axis, origin)));
}

/// The midpoint at which F decided between two rows in a step: below the previous step's row.
void drawCircleDecision(const NamedNumbers &setUp, const NamedNumbers &before,
                        const NamedNumbers &step, LayerDrawing &drawing)
{
    const Quantity decision = step[u"p_k"_s];
    if (decision.isNone())
        return; // no decision led to the first pixel of an arc
    const QPointF centre(setUp[u"x_c"_s].toDouble(), setUp[u"y_c"_s].toDouble());
    const double x = step[u"x_k"_s].toDouble();
    const double stays = before[u"y_k"_s].toDouble();
    const bool isSecondArc = step[u"arc"_s] == Quantity::integer(2);
    const auto at = [&](double along, double across) {
        return centre + (isSecondArc ? QPointF(across, along) : QPointF(along, across));
    };
    drawing.points.push_back({at(x - 1, stays), LayerInk::Hand});
    drawing.points.push_back({at(x, stays), LayerInk::First});
    drawing.points.push_back({at(x, stays - 1), LayerInk::Second});
    drawing.lines.push_back({at(x, stays), at(x, stays - 1), LayerInk::Mark});
    drawing.points.push_back({at(x, stays - 0.5), LayerInk::Third});
    drawing.labels.push_back({named("F = p_k", decision), at(x, stays - 0.5), LayerInk::Third});
}

void drawDecision(const LayerMoment &moment, LayerDrawing &drawing)
{
    const std::optional<std::size_t> span = moment.currentSpan();
    if (!span)
        return;
    const SpanRecord record = moment.trace().span(*span);
    const std::vector<NumberDescription> &numbers = moment.trace().numbers().span;
    const NamedNumbers step(numbers, record.cells);
    const bool isFirst = *span == moment.trace().firstSpanOf(moment.primitive);
    const SpanRecord before = isFirst ? record : moment.trace().span(*span - 1);
    const SetUpRecord begin = moment.trace().setUp(moment.primitive);
    const NamedNumbers setUp(moment.trace().numbers().setUp, begin.cells);
    const PrimitiveKind kind = moment.primitives().kindOf(moment.primitive);
    if (kind == PrimitiveKind::Line)
        drawLineDecision(setUp, record.place.axis, step, moment.frame().origin, drawing);
    else if (kind == PrimitiveKind::Polygon) // each step has the set-up of its edge
        drawLineDecision(step, record.place.axis, step, moment.frame().origin, drawing);
    else
        drawCircleDecision(setUp, NamedNumbers(numbers, before.cells), step, drawing);
}

} // namespace

Layer decisionsLayer()
{
    return {
        .id = "decisions",
        .title = QT_TRANSLATE_NOOP("core", "Decision of the step"),
        .toolTip
        = "Of a line or an edge by Bresenham, d_lower to the pixel that stays and d_upper to the "
          "one across, at the current step, measured beside it; of a circle, the two pixels that "
          "the step chose from, the midpoint between them and its F, by whose sign it chose.",
        .source = "Rasterization slides, “Bresenham's Line Algorithm (1/4)”; Scan Conversion "
                  "slides, “Lines and Curves: Implicit”",
        .kinds = {PrimitiveKind::Line, PrimitiveKind::Circle, PrimitiveKind::Ellipse,
                  PrimitiveKind::Polygon},
        .methods
        = {"line-bresenham", "line-bresenham-symmetric", "circle-midpoint", "polygon-outline"},
        .draw = drawDecision};
}

} // namespace pixelplumb
