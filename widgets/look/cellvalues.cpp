// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/cellvalues.h"

#include "widgets/look/appearance.h"

#include <QtWidgets>

#include <algorithm>
#include <array>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

// Logical pixels.
// A value is between the cell's left side and the lines through its sample.
constexpr double leastValueSize = 7; // of its font
constexpr double largestValueSize = 12;
constexpr double valueGap = 1.5; // from the side
constexpr double sampleGap = 2.5; // from the middle

QFont withSize(QFont font, double size)
{
    font.setPixelSize(std::max(1, int(size)));
    return font;
}

/// Equal in both notations, so that nothing moves when they are switched.
double widestValue(const QFont &font) { return QFontMetricsF(font).horizontalAdvance(u"000"_s); }

QString byteText(int byte, ByteNotation notation)
{
    return notation == ByteNotation::Decimal ? QString::number(byte)
                                             : u"%1"_s.arg(byte, 2, 16, QLatin1Char('0'));
}

} // namespace

QColor textColourOn(QRgb colour)
{
    return luminance(QColor::fromRgb(colour)) > 0.179 ? Qt::black : Qt::white;
}

double leastReadableCell(const CellValueStyle &style)
{
    const double value = widestValue(withSize(style.font, leastValueSize));
    return 2 * (value + valueGap + sampleGap);
}

void drawCellValues(QPainter &painter, const QRectF &cell, QRgb colour, const QColor &ink,
                    const CellValueStyle &style)
{
    const double size = cell.height();
    if (size < leastReadableCell(style))
        return;
    const double room = size / 2 - (valueGap + sampleGap);
    const double lineHeight = (size - 2) / 3;
    double fontSize = largestValueSize;
    while (fontSize > leastValueSize
           && (widestValue(withSize(style.font, fontSize)) > room || fontSize > lineHeight))
        --fontSize;
    const QFont font = withSize(style.font, fontSize);
    const QFontMetricsF metrics(font);
    painter.setPen(ink);
    painter.setFont(font);
    const double right = cell.left() + valueGap + widestValue(font);
    const std::array<int, 3> bytes = {qRed(colour), qGreen(colour), qBlue(colour)};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const QString text = byteText(bytes[i], style.notation);
        const double middle = cell.top() + 1 + lineHeight * (double(i) + 0.5);
        const double left = right - metrics.horizontalAdvance(text);
        const double height = metrics.capHeight();
        painter.fillRect(
            QRectF(left, middle - height / 2, right - left, height).adjusted(-1, -1, 1, 1),
            QColor::fromRgb(colour));
        painter.drawText(QPointF(left, middle + height / 2), text);
    }
}

} // namespace pixelplumb
