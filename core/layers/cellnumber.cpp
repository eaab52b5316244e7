// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"

#include <cmath>

namespace pixelplumb {

namespace {

constexpr int mostPlaces = 6; ///< else a power of ten takes less room

} // namespace

QString cellNumber(const Quantity &number)
{
    if (number.isNone())
        return {};
    if (number.isInteger())
        return withMinus(toText(number));
    const double size = std::abs(number.toDouble());
    if (size < 0.001)
        return withMinus(QString::number(number.toDouble(), 'g', 1));
    return withMinus(toDecimal(number, size < 0.1 ? 3 : size < 10 ? 2 : 1));
}

QString preciseNumber(const Quantity &number)
{
    const double size = std::abs(number.toDouble());
    if (number.isNone() || number.isInteger() || size >= 1)
        return cellNumber(number);
    // With enough places to show three digits after the zeros.
    const int places = 2 - int(std::floor(std::log10(size)));
    return withMinus(places <= mostPlaces ? toDecimal(number, places)
                                          : QString::number(number.toDouble(), 'g', 3));
}

LayerInk inkOf(const Quantity &number)
{
    return number.toDouble() < 0 ? LayerInk::Negative : LayerInk::Mark;
}

QString smallCellNote()
{
    return u"Zoom in to read the numbers: a cell needs %1 pixels"_s.arg(leastNumberCell);
}

} // namespace pixelplumb
