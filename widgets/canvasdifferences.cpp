// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvasdifferences.h"

#include "widgets/framepainter.h"

#include <QPainter>

namespace pixelplumb {

void CanvasDifferences::lookUp(const std::shared_ptr<const TracedScene> &traced,
                               const ViewMapping &mapping, const QRect &device)
{
    if (traced == m_traced && mapping == m_mapping && device == m_device)
        return;
    m_traced = traced;
    m_mapping = mapping;
    m_device = device;
    m_marks.clear();
    if (!traced || traced->differences.total() == 0)
        return;
    if (mapping.zoom().framePixels > 1)
        lookUpBlocks();
    else
        lookUpCells(mapping.pictureIn(device));
}

void CanvasDifferences::lookUpCells(const QRect &cells)
{
    const FrameSpec &frame = m_mapping.frame();
    for (int line = cells.top(); line <= cells.bottom(); ++line) {
        const std::int64_t y = rowOfPictureLine(frame, line);
        for (int column = cells.left(); column <= cells.right(); ++column) {
            const int x = frame.firstColumn + column;
            const Difference kind = m_traced->differences.at(x, y);
            if (kind == Difference::None)
                continue;
            const QPoint device = m_mapping.deviceCellOf({x, int(y)}).topLeft();
            m_marks.push_back({device - m_device.topLeft(), kind, m_traced->decidedAt(x, y)});
        }
    }
}

void CanvasDifferences::lookUpBlocks()
{
    const int side = m_mapping.zoom().framePixels;
    const QPoint origin = m_mapping.origin();
    for (int y = m_device.top(); y <= m_device.bottom(); ++y) {
        for (int x = m_device.left(); x <= m_device.right(); ++x) {
            const QRect block((x - origin.x()) * side, (y - origin.y()) * side, side, side);
            std::size_t decidedAt = 0;
            const Difference kind = firstDifferenceIn(block, decidedAt);
            if (kind != Difference::None)
                m_marks.push_back({QPoint(x, y) - m_device.topLeft(), kind, decidedAt});
        }
    }
}

Difference CanvasDifferences::firstDifferenceIn(const QRect &picture, std::size_t &decidedAt) const
{
    const FrameSpec &frame = m_mapping.frame();
    for (int line = picture.top(); line <= picture.bottom(); ++line) {
        const std::int64_t y = rowOfPictureLine(frame, line);
        for (int column = picture.left(); column <= picture.right(); ++column) {
            const std::int64_t x = std::int64_t(frame.firstColumn) + column;
            const Difference kind = m_traced->differences.at(x, y);
            if (kind != Difference::None) {
                decidedAt = m_traced->decidedAt(x, y);
                return kind;
            }
        }
    }
    return Difference::None;
}

void CanvasDifferences::makeStamps(const QPalette &palette)
{
    const int zoom = m_mapping.zoom().devicePixels;
    const double ratio = m_mapping.devicePixelRatio();
    if (m_stampsZoom == zoom && m_stampsPalette == palette.cacheKey() && m_stampsRatio == ratio)
        return;
    for (const Difference kind : {Difference::Missing, Difference::Extra, Difference::Colour}) {
        QImage stamp(zoom, zoom, QImage::Format_ARGB32_Premultiplied);
        stamp.fill(Qt::transparent);
        QPainter painter(&stamp);
        painter.scale(ratio, ratio);
        paintDifference(painter, QRectF(0, 0, zoom / ratio, zoom / ratio), kind, palette);
        painter.end();
        if (hasGlyphs())
            stamp.setDevicePixelRatio(ratio);
        m_stamps[std::size_t(kind)] = stamp;
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
    QPainter painter(&shown);
    for (const Mark &mark : m_marks) {
        if (mark.decidedAt <= position)
            painter.drawImage(mark.device, m_stamps[std::size_t(mark.kind)]);
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
                              m_stamps[std::size_t(mark.kind)]);
    }
}

} // namespace pixelplumb
