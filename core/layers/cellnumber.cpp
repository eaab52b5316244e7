// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"

#include <cmath>

namespace pixelplumb {

QString cellNumber(const Quantity &number)
{
    if (number.isNone())
        return {};
    const double size = std::abs(number.toDouble());
    const int places = size < 10 ? 2 : size < 100 ? 1 : 0;
    QString text = number.isInteger() ? toText(number) : toDecimal(number, places);
    return text.replace(u'-', QChar(0x2212));
}

LayerInk inkOf(const Quantity &number)
{
    return number.toDouble() < 0 ? LayerInk::Negative : LayerInk::Mark;
}

QString smallCellNote()
{
    return QStringLiteral("Numbers stand in cells of %1 pixels and more: enlarge the picture")
        .arg(leastNumberCell);
}

} // namespace pixelplumb
