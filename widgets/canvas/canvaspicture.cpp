// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvaspicture.h"

#include "widgets/look/cellvalues.h"

#include <QPainter>

#include <cstring>
#include <vector>

namespace pixelplumb {

namespace {

constexpr int mostValues = 2'500; ///< cells; drawing more would delay the pointer

} // namespace

void enlargePicture(const QImage &picture, const ViewMapping &mapping, const QRect &device,
                    QImage &shown)
{
    Q_ASSERT(mapping.devicePicture().contains(device));
    if (shown.size() != device.size())
        shown = QImage(device.size(), QImage::Format_RGB32);

    std::vector<int> columns(std::size_t(device.width()));
    for (int x = 0; x < device.width(); ++x)
        columns[std::size_t(x)] = mapping.pictureColumnAt(device.left() + x);

    const bool isCopied = mapping.zoom() == ViewZoom{1, 1};
    int previousLine = -1;
    for (int y = 0; y < device.height(); ++y) {
        const int line = mapping.pictureLineAt(device.top() + y);
        uchar *const target = shown.scanLine(y);
        if (line == previousLine) {
            std::memcpy(target, shown.constScanLine(y - 1), std::size_t(shown.bytesPerLine()));
            continue;
        }
        const auto *const source = reinterpret_cast<const QRgb *>(picture.constScanLine(line));
        if (isCopied) {
            std::memcpy(target, source + columns[0], std::size_t(device.width()) * sizeof(QRgb));
            continue;
        }
        auto *const pixels = reinterpret_cast<QRgb *>(target);
        for (int x = 0; x < device.width(); ++x)
            pixels[x] = source[columns[std::size_t(x)]];
        previousLine = line;
    }
}

void drawValues(QPainter &painter, const FrameBuffer &frame, const ViewMapping &mapping,
                const QRectF &area, ByteNotation notation)
{
    const CellValueStyle style{painter.font(), 1, notation};
    if (mapping.zoom().factor() / mapping.devicePixelRatio() < leastReadableCell(style))
        return;
    const QRect part = mapping.pictureIn(mapping.deviceRect(area) & mapping.devicePicture());
    if (part.width() * part.height() > mostValues)
        return;
    painter.save();
    for (int line = part.top(); line <= part.bottom(); ++line) {
        const auto y = int(rowOfPictureLine(frame.spec(), line));
        for (int column = part.left(); column <= part.right(); ++column) {
            const QPoint pixel(frame.spec().firstColumn + column, y);
            const QRgb colour = *frame.view().at(pixel.x(), pixel.y());
            drawCellValues(painter, mapping.cellOf(pixel), colour, textColourOn(colour), style);
        }
    }
    painter.restore();
}

void blendGrid(QImage &shown, const ViewMapping &mapping, const QRect &device, const QColor &colour)
{
    const int cell = mapping.zoom().devicePixels;
    if (colour.alpha() == 0 || cell < 2)
        return;
    // One tiled fill costs a fraction of hundreds of thin translucent rectangles.
    QImage tile(cell, cell, QImage::Format_ARGB32_Premultiplied);
    tile.fill(Qt::transparent);
    QPainter lines(&tile);
    lines.fillRect(0, 0, cell, 1, colour);
    lines.fillRect(0, 1, 1, cell - 1, colour);
    lines.end();
    QPainter painter(&shown);
    painter.setBrushOrigin(mapping.origin() - device.topLeft());
    painter.fillRect(shown.rect(), QBrush(tile));
}

} // namespace pixelplumb
