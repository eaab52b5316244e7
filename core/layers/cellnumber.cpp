// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"

#include <cmath>

namespace pixelplumb {

QString cellNumber(const Quantity &number)
{
    if (number.isNone())
        return {};
    const int places = std::abs(number.toDouble()) < 10 ? 2 : 1;
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
