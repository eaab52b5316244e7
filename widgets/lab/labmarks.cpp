// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labmarks.h"

#include "widgets/studies/precisionplot.h"

namespace pixelplumb {

namespace {

constexpr double dotSize = 9; ///< logical pixels

QCPScatterStyle::ScatterShape dotShapeOf(Arithmetic arithmetic)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        break;
    case Arithmetic::Float32:
        return QCPScatterStyle::ssTriangle;
    case Arithmetic::Float64:
        return QCPScatterStyle::ssSquare;
    case Arithmetic::Fixed16:
        return QCPScatterStyle::ssDiamond;
    case Arithmetic::Fixed32:
        return QCPScatterStyle::ssTriangleInverted;
    }
    return QCPScatterStyle::ssCircle;
}

} // namespace

QCPScatterStyle arithmeticDot(Arithmetic arithmetic, DotFill fill, const QPalette &palette)
{
    const QColor colour = arithmeticColour(arithmetic, palette);
    const QBrush inside(fill == DotFill::Solid ? colour : palette.color(QPalette::Base));
    return {dotShapeOf(arithmetic), QPen(colour, 1.5), inside, dotSize};
}

} // namespace pixelplumb
