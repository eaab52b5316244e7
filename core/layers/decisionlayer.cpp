// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layers.h"
#include "core/scan/linebresenham.h"

namespace pixelplumb {

namespace {

const QString wholeLineMethod = QStringLiteral("line-bresenham");

QString named(const QString &name, const Quantity &number)
{
    return QStringLiteral("%1 = %2").arg(name, cellNumber(number));
}

/// From where to where the kernel goes: it may take whole-pixel ends.
struct LineRun {
    LatticePoint from, to;

    explicit LineRun(const LayerMoment &moment)
    {
        const bool takesPixels = moment.view.traced->method->id == wholeLineMethod;
        const auto endOf = [&](std::size_t vertex) {
            const Vertex &end = moment.shape().vertices[vertex];
            return (takesPixels ? onPixel(end) : end).position;
        };
        from = endOf(0);
        to = endOf(1);
    }

    bool isSteep() const { return lineAxisOf(from, to) == LineAxis::Y; }
    /// Whether it goes down across while it goes up along.
    bool falls() const
    {
        return (to.x < from.x && to.y > from.y) || (to.x > from.x && to.y < from.y);
    }
};

/// Rasterization slides, "Bresenham's Line Algorithm (1/4)": the line between the pixel that stays
/// and the one across, d_lower and d_upper away.
void drawLineDecision(const LayerMoment &moment, const NamedNumbers &step, LayerDrawing &drawing)
{
    const Quantity stays = step[QStringLiteral("y_k")];
    const Quantity line = step[QStringLiteral("y_line")];
    const Quantity lower = step[QStringLiteral("d_lower")];
    const Quantity upper = step[QStringLiteral("d_upper")];
    if (stays.isNone() || line.isNone())
        return; // no decision led to the first pixel
    const LineRun run(moment);
    const bool steep = run.isSteep();
    const double along = step[steep ? QStringLiteral("y") : QStringLiteral("x")].toDouble();
    // d_lower and d_upper are 1 together, towards the pixel across.
    const double across = stays.toDouble() + (run.falls() ? -1 : 1);
    const auto at = [&](double distance) {
        return steep ? QPointF(distance, along) : QPointF(along, distance);
    };
    drawing.lines.push_back({at(stays.toDouble()), at(line.toDouble()), LayerInk::First});
    drawing.lines.push_back({at(across), at(line.toDouble()), LayerInk::Second});
    drawing.points.push_back({at(stays.toDouble()), LayerInk::First});
    drawing.points.push_back({at(across), LayerInk::Second});
    drawing.points.push_back({at(line.toDouble()), LayerInk::Hand});
    drawing.labels.push_back(
        {named(QStringLiteral("d_lower"), lower), at(stays.toDouble()), LayerInk::First});
    drawing.labels.push_back(
        {named(QStringLiteral("d_upper"), upper), at(across), LayerInk::Second});
    drawing.labels.push_back({named(QStringLiteral("p_k"), step[QStringLiteral("p_k")]),
                              at(line.toDouble()), LayerInk::Hand});
}

/// The midpoint whose F decides which of two rows the next pixel is in.
void drawCircleDecision(const LayerMoment &moment, const NamedNumbers &step, LayerDrawing &drawing)
{
    const SetUpRecord setUp = moment.trace().setUp(moment.primitive);
    const NamedNumbers whole(moment.trace().numbers().setUp, setUp.cells);
    const QPointF centre(whole[QStringLiteral("x_c")].toDouble(),
                         whole[QStringLiteral("y_c")].toDouble());
    const double x = step[QStringLiteral("x_k")].toDouble();
    const double y = step[QStringLiteral("y_k")].toDouble();
    const bool isSecondArc = step[QStringLiteral("arc")] == Quantity::integer(2);
    const auto at = [&](double along, double across) {
        return centre + (isSecondArc ? QPointF(across, along) : QPointF(along, across));
    };
    drawing.points.push_back({at(x, y), LayerInk::Hand});
    drawing.points.push_back({at(x + 1, y), LayerInk::First});
    drawing.points.push_back({at(x + 1, y - 1), LayerInk::Second});
    drawing.lines.push_back({at(x + 1, y), at(x + 1, y - 1), LayerInk::Mark});
    drawing.points.push_back({at(x + 1, y - 0.5), LayerInk::Third});
    drawing.labels.push_back({named(QStringLiteral("F = p_k₊₁"), step[QStringLiteral("p_next")]),
                              at(x + 1, y - 0.5), LayerInk::Third});
}

void drawDecision(const LayerMoment &moment, LayerDrawing &drawing)
{
    const std::optional<std::size_t> span = moment.spanInHand();
    if (!span)
        return;
    const SpanRecord record = moment.trace().span(*span);
    const NamedNumbers step(moment.trace().numbers().span, record.cells);
    if (moment.primitives().kindOf(moment.primitive) == PrimitiveKind::Line)
        drawLineDecision(moment, step, drawing);
    else
        drawCircleDecision(moment, step, drawing);
}

} // namespace

Layer decisionsLayer()
{
    return {.id = QStringLiteral("decisions"),
            .title = QStringLiteral("Decision of the step"),
            .toolTip = QStringLiteral(
                "Of a line by Bresenham, d_lower from the pixel that stays and d_upper to the one "
                "across, at the step in hand; of a circle, the midpoint between two pixels and its "
                "F, which decides the next step."),
            .source = QStringLiteral("Rasterization slides, “Bresenham's Line Algorithm (1/4)”; "
                                     "Scan Conversion slides, “Lines and Curves: Implicit”"),
            .kinds = {PrimitiveKind::Line, PrimitiveKind::Circle, PrimitiveKind::Ellipse},
            .methods = {wholeLineMethod, QStringLiteral("line-bresenham-symmetric"),
                        QStringLiteral("circle-midpoint")},
            .draw = drawDecision};
}

} // namespace pixelplumb
