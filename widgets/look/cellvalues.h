// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/displayoptions.h"

#include <QFont>
#include <QRectF>
#include <QRgb>

class QPainter;

namespace pixelplumb {

/// How the three bytes of a pixel are written into its cell, left of its sample.
struct CellValueStyle {
    QFont font; ///< its size is chosen by the cell
    double scale = 1; ///< of the painter's units: how many make a logical pixel
    ByteNotation notation = ByteNotation::Decimal;
};

/// Black or white, whichever is read better on a colour: relative luminance of sRGB against its
/// middle (WCAG 2.1).
QColor textColourOn(QRgb colour);

/// The smallest cell that has room for three numbers beside its sample, painter's units.
double leastReadableCell(const CellValueStyle &style);

/// R, G and B one below the other, as large as fits; nothing in cells that are too small. They
/// stand on the cell's colour, so that no line that is there already runs through the digits.
void drawCellValues(QPainter &painter, const QRectF &cell, QRgb colour, const QColor &ink,
                    const CellValueStyle &style);

} // namespace pixelplumb
