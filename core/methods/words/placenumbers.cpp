// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

NumberDescription plainNumber(const QString &id, const QString &title, const QString &unit,
                              const QString &toolTip, const QString &formula, NumberGroup group)
{
    return {.id = id,
            .title = title,
            .unit = unit,
            .toolTip = toolTip,
            .formula = formula,
            .group = group};
}

NumberDescription comparedNumber(const QString &id, const QString &title, const QString &unit,
                                 const QString &toolTip, const QString &formula, NumberGroup group)
{
    NumberDescription number = plainNumber(id, title, unit, toolTip, formula, group);
    number.comparison = Comparison::WithExact;
    return number;
}

namespace {

NumberDescription pixelCoordinate(const QString &axis)
{
    return plainNumber(axis, axis, "px", u"The pixel's %1."_s.arg(axis), {}, NumberGroup::Span);
}

} // namespace

NumberDescription triangleNumber()
{
    return plainNumber("primitive", "tri", {}, "The triangle's place in drawing order, from 0.");
}

NumberDescription scannedNumber(const QString &formula)
{
    return plainNumber("x", "x", "px", "The column.", formula);
}

NumberDescription halfNumber()
{
    return plainNumber("half", "half", {}, "1: between L₀₁ and L₀₂; 2: between L₁₂ and L₀₂.");
}

NumberDescription columnPixelsNumber()
{
    return plainNumber("pixels", "px", {}, "Pixels written in this column, inside the frame.", {},
                       NumberGroup::Span);
}

NumberDescription pixelX() { return pixelCoordinate("x"); }
NumberDescription pixelY() { return pixelCoordinate("y"); }

} // namespace pixelplumb
