// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/pixelgridpainter.h"

#include "widgets/look/signs.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double dotCell = 12; // a dot would hide smaller cells

constexpr float backgroundValueFade = 0.55F;

} // namespace

PixelGridPainter::PixelGridPainter(QPainter &painter, const PixelGridStyle &style,
                                   const ViewMapping &mapping, const PixelGridScene &scene)
    : m_painter(painter)
    , m_style(style)
    , m_mapping(mapping)
    , m_grid(mapping.positionOfDevice(mapping.devicePicture().topLeft()),
             QSizeF(mapping.devicePicture().size()) / mapping.devicePixelRatio())
    , m_scene(scene)
{
}

bool PixelGridPainter::hasCell(const QPoint &pixel) const
{
    return windowOf(m_mapping.frame()).contains(pixel.x(), pixel.y());
}

void PixelGridPainter::paint()
{
    for (const GridCell &cell : m_scene.cells)
        paintCell(cell);
    FramePainter frame(m_painter, m_mapping, m_style.palette, m_grid);
    if (m_style.lines == GridLines::Shown) {
        frame.drawGrid();
        frame.drawFrameEdge();
    }
    m_painter.save();
    m_painter.setClipRect(m_grid);
    if (m_scene.triangle)
        frame.drawOutline(*m_scene.triangle, m_scene.roles);
    if (m_scene.hasLine())
        frame.drawPlumbLine(m_scene.span->place);
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    paintSamples();
    paintCandidates();
    paintCurrentPixel();
    if (m_scene.picked)
        frame.drawPickedPixel(*m_scene.picked);
    paintSpan(frame);
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    for (const GridCell &cell : m_scene.cells)
        paintValue(cell); // over lines and frames, which may cross it
    for (const GridCell &cell : m_scene.cells)
        paintSigns(cell);
    m_painter.restore();
    paintAxes();
    paintSpanLabels();
}

void PixelGridPainter::paintCell(const GridCell &cell)
{
    const QRectF rect = m_mapping.cellOf(cell.pixel);
    if (cell.isInFrame) {
        m_painter.fillRect(rect, QColor::fromRgb(cell.colour));
        return;
    }
    m_painter.fillRect(rect, m_style.palette.color(QPalette::Window));
    m_painter.fillRect(rect, QBrush(m_style.palette.color(QPalette::Mid), Qt::BDiagPattern));
}

void PixelGridPainter::paintValue(const GridCell &cell)
{
    if (!cell.isInFrame)
        return;
    QColor ink = textColourOn(cell.colour);
    if (cell.isBackground)
        ink = blended(ink, QColor::fromRgb(cell.colour), backgroundValueFade);
    drawCellValues(m_painter, m_mapping.cellOf(cell.pixel), cell.colour, ink, m_style.values());
}

void PixelGridPainter::paintSamples()
{
    const double size = cellSize();
    if (size < dotCell)
        return;
    const double radius = std::clamp(size / 24, 1.0, 2.5);
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    for (const GridCell &cell : m_scene.cells) {
        if (!cell.isInFrame)
            continue;
        const QColor dot = textColourOn(cell.colour);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(blended(dot, QColor::fromRgb(cell.colour), 0.3F));
        m_painter.drawEllipse(m_mapping.positionOf(cell.pixel), radius, radius);
    }
    m_painter.restore();
}

void PixelGridPainter::paintCandidates()
{
    if (!m_scene.hasLine())
        return;
    const bool isRow = m_scene.span->place.axis == SpanAxis::Row;
    const FrameView shown = windowOf(m_mapping.frame());
    const std::int64_t first = std::max<std::int64_t>(m_scene.firstCandidate,
                                                      isRow ? shown.firstColumn : shown.firstRow);
    const std::int64_t end
        = std::min(m_scene.endCandidate, isRow ? shown.endColumn() : shown.endRow());
    const double inset = 3;
    QPen pen(colour(Sign::CurrentColumn), 1.5);
    pen.setDashPattern({3, 2});
    QPen halo(m_style.palette.color(QPalette::Base), 1.5);
    for (std::int64_t along = first; along < end; ++along) {
        const QRectF rect
            = m_mapping.cellOf(m_scene.onSpan(along)).adjusted(inset, inset, -inset, -inset);
        m_painter.setPen(halo);
        m_painter.drawRect(rect);
        m_painter.setPen(pen);
        m_painter.drawRect(rect);
    }
}

void PixelGridPainter::paintCurrentPixel()
{
    if (!m_scene.currentPixel || !hasCell(*m_scene.currentPixel))
        return;
    const double inset = 3;
    const QRectF rect
        = m_mapping.cellOf(*m_scene.currentPixel).adjusted(inset, inset, -inset, -inset);
    m_painter.setPen(QPen(m_style.palette.color(QPalette::Base), 4));
    m_painter.drawRect(rect);
    m_painter.setPen(QPen(colour(Sign::CurrentColumn), 2));
    m_painter.drawRect(rect);
}

void PixelGridPainter::paintSigns(const GridCell &cell)
{
    const double size = cellSize();
    if (cell.signs.empty() || size < 12)
        return;
    const QFont font = [&] {
        QFont bold = m_style.font;
        bold.setPixelSize(int(std::clamp(size / 3.4, 7.0, 13.0)));
        bold.setBold(true);
        return bold;
    }();
    const QFontMetricsF metrics(font);
    const double side = std::min(metrics.height() * 0.95, size / 2 - 2); // right of the values
    const QRectF rect = m_mapping.cellOf(cell.pixel);
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    m_painter.setFont(font);
    double top = rect.top() + 1;
    for (const Sign sign : cell.signs) {
        const QRectF badge(rect.right() - side - 1, top, side, side);
        m_painter.setPen(QPen(colour(sign), 1));
        m_painter.setBrush(m_style.palette.color(QPalette::Base));
        m_painter.drawRoundedRect(badge, 2, 2);
        m_painter.drawText(badge, Qt::AlignCenter, signGlyph(sign));
        top += side + 1;
    }
    m_painter.restore();
}

} // namespace pixelplumb
