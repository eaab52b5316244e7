// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

NumberDescription pixelCoordinate(const QString &axis)
{
    return {.id = axis,
            .title = axis,
            .unit = QStringLiteral("px"),
            .toolTip = QStringLiteral("The pixel's %1.").arg(axis),
            .formula = {},
            .group = NumberGroup::Span};
}

} // namespace

NumberDescription triangleNumber()
{
    return {.id = QStringLiteral("primitive"),
            .title = QStringLiteral("tri"),
            .unit = {},
            .toolTip = QStringLiteral("The triangle's place in drawing order, from 0."),
            .formula = {}};
}

NumberDescription scannedNumber(const QString &formula)
{
    return {.id = QStringLiteral("x"),
            .title = QStringLiteral("x"),
            .unit = QStringLiteral("px"),
            .toolTip = QStringLiteral("The column."),
            .formula = formula};
}

NumberDescription halfNumber()
{
    return {.id = QStringLiteral("half"),
            .title = QStringLiteral("half"),
            .unit = {},
            .toolTip = QStringLiteral("1: between L₀₁ and L₀₂; 2: between L₁₂ and L₀₂."),
            .formula = {}};
}

NumberDescription columnPixelsNumber()
{
    return {.id = QStringLiteral("pixels"),
            .title = QStringLiteral("px"),
            .unit = {},
            .toolTip = QStringLiteral("Pixels written in this column, inside the frame."),
            .formula = {},
            .group = NumberGroup::Span};
}

NumberDescription pixelX() { return pixelCoordinate(QStringLiteral("x")); }
NumberDescription pixelY() { return pixelCoordinate(QStringLiteral("y")); }

} // namespace pixelplumb
