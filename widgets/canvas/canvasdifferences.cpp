// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasdifferences.h"

#include "widgets/look/framepainter.h"

#include <cstring>
#include <utility>

namespace pixelplumb {

namespace {

/// Every pixel of the picture that is in some of the device pixels; below 1:1 several share one.
QRect picturePixelsIn(const QRect &device, const ViewMapping &mapping)
{
    const int side = mapping.zoom().framePixels;
    if (side == 1)
        return mapping.pictureIn(device);
    const QRect blocks = (device & mapping.devicePicture()).translated(-mapping.origin());
    const FrameSpec &frame = mapping.frame();
    return QRect(blocks.topLeft() * side, blocks.size() * side)
        & QRect(0, 0, frame.width, frame.height);
}

/// The first differing pixel from `column` on; the row's length where there is none. Tests eight
/// bytes at once, because most are 0.
template <class Kind>
std::size_t nextDifference(std::span<const Kind> row, std::size_t column)
{
    static_assert(sizeof(Kind) == 1);
    while (column < row.size()) {
        std::uint64_t eight = 1;
        if (column + sizeof(eight) <= row.size())
            std::memcpy(&eight, row.data() + column, sizeof(eight));
        if (eight == 0)
            column += sizeof(eight);
        else if (row[column] != Kind())
            return column;
        else
            ++column;
    }
    return row.size();
}

// The marks are in the order of the signs.
static_assert(int(Difference::None) == 0 && int(Difference::Missing) == 1
              && int(Difference::Extra) == 2 && int(Difference::Colour) == 3
              && int(Difference::Undecidable) == 4);

} // namespace

void CanvasDifferences::forget()
{
    m_source = {};
    m_marks.clear();
}

void CanvasDifferences::lookUp(const Source &source, const ViewMapping &mapping,
                               const QRect &device)
{
    if (source == m_source && mapping == m_mapping && device == m_device)
        return;
    m_source = source;
    m_mapping = mapping;
    m_device = device;
    m_marks.clear();
    const QRect cells = picturePixelsIn(device, mapping);
    if (source.judgement) {
        const PictureDiff &diff = source.judgement->diff;
        const std::span<const Difference> all = diff.verdicts;
        lookUpCells(cells, [&](std::int64_t y) {
            const int line = pictureLine(mapping.frame(), y);
            return all.subspan(std::size_t(line) * std::size_t(diff.width),
                               std::size_t(diff.width));
        });
    } else if (const DifferenceMap &differences = source.differences(); differences.total() > 0) {
        lookUpCells(cells, [&differences](std::int64_t y) { return differences.row(y); });
    }
}

template <class RowAt>
void CanvasDifferences::lookUpCells(const QRect &cells, RowAt rowAt)
{
    const FrameSpec &frame = m_mapping.frame();
    const ViewZoom &zoom = m_mapping.zoom();
    const int side = zoom.framePixels;
    const QPoint corner = m_mapping.origin() - m_device.topLeft();
    // Below 1:1 a block is marked by its first difference, line by line.
    std::vector<int> lastMarked(std::size_t(cells.right() / side + 1), -1);
    for (int line = cells.top(); line <= cells.bottom(); ++line) {
        const std::int64_t y = rowOfPictureLine(frame, line);
        const auto row = rowAt(y).first(std::size_t(cells.right() + 1));
        for (std::size_t at = std::size_t(cells.left());
             (at = nextDifference(row, at)) < row.size(); ++at) {
            const QPoint block(int(at) / side, line / side);
            if (std::exchange(lastMarked[std::size_t(block.x())], block.y()) == block.y())
                continue;
            const std::int64_t x = frame.firstColumn + std::int64_t(at);
            m_marks.push_back({corner + block * zoom.devicePixels, std::size_t(row[at]) - 1,
                               m_source.decidedAt(x, y)});
        }
    }
}

void CanvasDifferences::makeStamps(const QPalette &palette)
{
    const int zoom = m_mapping.zoom().devicePixels;
    const double ratio = m_mapping.devicePixelRatio();
    if (m_stampsZoom == zoom && m_stampsPalette == palette.cacheKey() && m_stampsRatio == ratio)
        return;
    for (std::size_t sign = 0; sign < markSigns.size(); ++sign) {
        QImage stamp(zoom, zoom, QImage::Format_ARGB32_Premultiplied);
        stamp.fill(Qt::transparent);
        QPainter painter(&stamp);
        painter.scale(ratio, ratio);
        paintMark(painter, QRectF(0, 0, zoom / ratio, zoom / ratio), markSigns[sign], palette);
        painter.end();
        if (hasGlyphs())
            stamp.setDevicePixelRatio(ratio);
        m_stamps[sign] = stamp;
    }
    m_stampsZoom = zoom;
    m_stampsPalette = palette.cacheKey();
    m_stampsRatio = ratio;
}

bool CanvasDifferences::hasGlyphs() const
{
    return m_mapping.zoom().devicePixels >= leastGlyphCell * m_mapping.devicePixelRatio();
}

void CanvasDifferences::markCells(QImage &shown, std::size_t position, const QPalette &palette)
{
    if (m_marks.empty() || hasGlyphs())
        return;
    makeStamps(palette);
    if (m_mapping.zoom().devicePixels == 1) {
        markDevicePixels(shown, position);
        return;
    }
    QPainter painter(&shown);
    for (const Mark &mark : m_marks) {
        if (mark.decidedAt <= position)
            painter.drawImage(mark.device, m_stamps[mark.sign]);
    }
}

/// Works without a QPainter, which takes longer for one pixel than drawing ten of them.
void CanvasDifferences::markDevicePixels(QImage &shown, std::size_t position) const
{
    std::array<QRgb, markSigns.size()> colours = {};
    for (std::size_t sign = 0; sign < colours.size(); ++sign)
        colours[sign] = m_stamps[sign].pixel(0, 0) | 0xff000000;
    for (const Mark &mark : m_marks) {
        if (mark.decidedAt <= position && shown.rect().contains(mark.device))
            reinterpret_cast<QRgb *>(shown.scanLine(mark.device.y()))[mark.device.x()]
                = colours[mark.sign];
    }
}

void CanvasDifferences::drawGlyphs(QPainter &painter, std::size_t position, const QPalette &palette)
{
    if (m_marks.empty() || !hasGlyphs())
        return;
    makeStamps(palette);
    for (const Mark &mark : m_marks) {
        if (mark.decidedAt <= position)
            painter.drawImage(m_mapping.positionOfDevice(m_device.topLeft() + mark.device),
                              m_stamps[mark.sign]);
    }
}

} // namespace pixelplumb
