// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/framepainter.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double leastFramedCell = 4;
constexpr double largestGlyph = 22;

/// The glyph's outline with its ink centred in a cell.
QPainterPath glyphPath(const QString &glyph, QFont font, const QRectF &cell)
{
    font.setBold(true);
    font.setPixelSize(int(std::min(cell.height(), largestGlyph)));
    QPainterPath path;
    path.addText(0, 0, font, glyph);
    path.translate(cell.center() - path.boundingRect().center());
    return path;
}

} // namespace

void drawCellNumbers(QPainter &painter, const ViewMapping &mapping, const QRectF &view,
                     const QWidget &widget,
                     const std::function<std::optional<int>(const QPoint &)> &numberAt)
{
    const double cell = cellSideOf(mapping);
    if (mapping.zoom().framePixels > 1 || cell < leastGlyphCell)
        return;
    QFont digits = widget.font();
    digits.setBold(true);
    digits.setPixelSize(int(std::min(cell, largestGlyph)));
    painter.setFont(digits);
    painter.setPen(isDark(widget.palette()) ? Qt::black : Qt::white);
    const QRect part = mapping.pictureIn(mapping.deviceRect(view) & mapping.devicePicture());
    forEachPixel(mapping.frame(), part, [&](const QPoint &pixel) {
        if (const std::optional<int> number = numberAt(pixel))
            painter.drawText(mapping.cellOf(pixel), Qt::AlignCenter, QString::number(*number));
    });
}

void paintDifference(QPainter &painter, const QRectF &cell, Difference kind,
                     const QPalette &palette)
{
    if (kind != Difference::None)
        paintMark(painter, cell, signOf(kind), palette);
}

void paintMark(QPainter &painter, const QRectF &cell, Sign sign, const QPalette &palette)
{
    const QColor colour = signColour(sign, palette);
    if (cell.width() < leastFramedCell) {
        painter.fillRect(cell, colour);
        return;
    }
    const QColor casing = isDark(palette) ? Qt::black : Qt::white;
    painter.save();
    painter.setBrush(Qt::NoBrush);
    if (cell.width() < leastGlyphCell) {
        QPen pen(colour, 1);
        pen.setJoinStyle(Qt::MiterJoin);
        painter.setPen(pen);
        painter.drawRect(cell.adjusted(0.5, 0.5, -0.5, -0.5));
    } else {
        painter.setRenderHint(QPainter::Antialiasing);
        const QPainterPath glyph = glyphPath(signGlyph(sign), painter.font(), cell);
        painter.strokePath(glyph, QPen(casing, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.fillPath(glyph, colour);
    }
    painter.restore();
}

} // namespace pixelplumb
