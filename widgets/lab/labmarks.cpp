// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labmarks.h"

#include "widgets/studies/accuracy/precisionplot.h"

#include <array>

namespace pixelplumb {

namespace {

constexpr double dotSize = 9; ///< logical pixels
constexpr double pathSize = 6; ///< for a painter path, which is drawn unscaled
constexpr double besideCentre = 4; ///< logical pixels from the middle to each half of a double dot
constexpr double halfDot = 3.25; ///< half the size of such a half
constexpr float faint = 0.45F;

QCPScatterStyle::ScatterShape dotShapeOf(Arithmetic arithmetic)
{
    constexpr std::array shapes
        = {QCPScatterStyle::ssCircle, QCPScatterStyle::ssTriangle, QCPScatterStyle::ssSquare,
           QCPScatterStyle::ssDiamond, QCPScatterStyle::ssTriangleInverted};
    return shapes[std::size_t(arithmetic)];
}

/// The arithmetic's shape as a path around (x, 0).
QPainterPath dotPath(Arithmetic arithmetic, double x)
{
    constexpr double r = halfDot;
    QPainterPath path;
    switch (arithmetic) {
    case Arithmetic::Exact:
        path.addEllipse(QPointF(x, 0), r, r);
        break;
    case Arithmetic::Float32:
        path.addPolygon(QPolygonF({{x - r, r}, {x + r, r}, {x, -r}, {x - r, r}}));
        break;
    case Arithmetic::Float64:
        path.addRect(x - r, -r, 2 * r, 2 * r);
        break;
    case Arithmetic::Fixed16:
        path.addPolygon(QPolygonF({{x - r, 0}, {x, r}, {x + r, 0}, {x, -r}, {x - r, 0}}));
        break;
    case Arithmetic::Fixed32:
        path.addPolygon(QPolygonF({{x - r, -r}, {x + r, -r}, {x, r}, {x - r, -r}}));
        break;
    }
    return path;
}

} // namespace

QCPScatterStyle kernelDot(Arithmetic arithmetic, LabKernel kernel, const QPalette &palette)
{
    const QColor colour = arithmeticColour(arithmetic, palette);
    const QPen pen(colour, 1.5);
    if (kernel == LabKernel::Plain)
        return {dotShapeOf(arithmetic), pen, QBrush(colour), dotSize};
    if (kernel == LabKernel::Peer)
        return {QCPScatterStyle::ssCrossSquare, QPen(palette.color(QPalette::Text), 1.2),
                QBrush(Qt::NoBrush), dotSize};
    QPainterPath path = dotPath(arithmetic, -besideCentre);
    path.addPath(dotPath(arithmetic, besideCentre));
    return {path, QPen(colour, 1), QBrush(colour), pathSize};
}

QCPScatterStyle straightLoopDot(Arithmetic arithmetic, const QPalette &palette)
{
    return {dotShapeOf(arithmetic), QPen(arithmeticColour(arithmetic, palette), 1.5),
            QBrush(palette.color(QPalette::Base)), dotSize};
}

QCPScatterStyle waitingDot(QCPScatterStyle dot)
{
    QPen pen = dot.pen();
    QBrush brush = dot.brush();
    QColor colour = pen.color();
    colour.setAlphaF(faint);
    pen.setColor(colour);
    brush.setColor(colour);
    dot.setPen(pen);
    dot.setBrush(brush);
    return dot;
}

} // namespace pixelplumb
