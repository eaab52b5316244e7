// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/displayoptions.h"

#include <QtGui>

namespace pixelplumb {

/// How the three bytes of a pixel are written into its cell, left of its sample.
struct CellValueStyle {
    QFont font; ///< its size is chosen by the cell
    ByteNotation notation = ByteNotation::Decimal;
};

/// Black or white, whichever is easier to read on a colour: its sRGB relative luminance against the
/// middle (WCAG 2.1).
QColor textColourOn(QRgb colour);

/// The smallest cell with room for three numbers beside its sample.
double leastReadableCell(const CellValueStyle &style);

/// Draws R, G and B one below the other, as large as fits; nothing in cells that are too small.
/// Each has a patch of the cell's colour behind it, so that no line runs through the digits.
void drawCellValues(QPainter &painter, const QRectF &cell, QRgb colour, const QColor &ink,
                    const CellValueStyle &style);

} // namespace pixelplumb
