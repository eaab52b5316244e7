// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/pixelgridpainter.h"

#include "widgets/look/signs.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double dotCell = 12; // a dot would hide smaller cells

constexpr float backgroundValueFade = 0.55F;

QFont withSize(QFont font, double devicePixels)
{
    font.setPixelSize(std::max(1, int(devicePixels)));
    return font;
}

} // namespace

PixelGridPainter::PixelGridPainter(QPainter &painter, const PixelGridStyle &style,
                                   const PixelGridMapping &mapping, const PixelGridScene &scene)
    : m_painter(painter)
    , m_style(style)
    , m_mapping(mapping)
    , m_view(mapping.onScreen(style.scale))
    , m_scene(scene)
{
}

template <class Draw>
void PixelGridPainter::drawFrame(const Draw &draw)
{
    m_painter.save();
    m_painter.scale(m_style.scale, m_style.scale);
    const QRect grid = m_mapping.grid();
    FramePainter frame(
        m_painter, m_view, m_style.palette,
        {m_view.positionOfDevice(grid.topLeft()), QSizeF(grid.size()) / m_style.scale});
    draw(frame);
    m_painter.restore();
}

void PixelGridPainter::paint()
{
    for (const GridCell &cell : m_scene.cells)
        paintCell(cell);
    if (m_style.lines == GridLines::Shown) {
        drawFrame([](FramePainter &frame) {
            frame.drawGrid();
            frame.drawFrameEdge();
        });
    }
    m_painter.save();
    m_painter.setClipRect(m_mapping.grid());
    drawFrame([this](FramePainter &frame) {
        if (m_scene.triangle)
            frame.drawOutline(*m_scene.triangle, m_scene.roles);
        if (m_scene.hasLine())
            frame.drawPlumbLine(m_scene.span->place);
    });
    paintSamples();
    paintCandidates();
    paintCurrentPixel();
    drawFrame([this](FramePainter &frame) {
        if (m_scene.picked)
            frame.drawPickedPixel(*m_scene.picked);
        paintSpan(frame);
    });
    for (const GridCell &cell : m_scene.cells)
        paintValue(cell); // over lines and frames, which may cross it
    for (const GridCell &cell : m_scene.cells)
        paintSigns(cell);
    m_painter.restore();
    paintAxes();
    paintSpanLabels();
}

QFont PixelGridPainter::fontOfSize(double logicalPixels) const
{
    return withSize(m_style.font, px(logicalPixels));
}

void PixelGridPainter::paintCell(const GridCell &cell)
{
    const QRect rect = m_mapping.cell(cell.pixel);
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
    drawCellValues(m_painter, m_mapping.cell(cell.pixel), cell.colour, ink, m_style.values());
}

void PixelGridPainter::paintSamples()
{
    const double size = m_mapping.cellSize();
    if (size < px(dotCell))
        return;
    const double radius = std::clamp(size / 24, px(1), px(2.5));
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    for (const GridCell &cell : m_scene.cells) {
        if (!cell.isInFrame)
            continue;
        const QColor dot = textColourOn(cell.colour);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(blended(dot, QColor::fromRgb(cell.colour), 0.3F));
        m_painter.drawEllipse(m_mapping.sample(cell.pixel), radius, radius);
    }
    m_painter.restore();
}

void PixelGridPainter::paintCandidates()
{
    if (!m_scene.hasLine())
        return;
    const bool isRow = m_scene.span->place.axis == SpanAxis::Row;
    const std::int64_t firstShown = isRow ? m_mapping.firstColumn() : m_mapping.firstRow();
    const std::int64_t endShown = isRow ? m_mapping.endColumn() : m_mapping.endRow();
    const std::int64_t first = std::max(m_scene.firstCandidate, firstShown);
    const std::int64_t end = std::min(m_scene.endCandidate, endShown);
    const double inset = px(3);
    QPen pen(colour(Sign::CurrentColumn), px(1.5));
    pen.setDashPattern({3, 2});
    QPen halo(m_style.palette.color(QPalette::Base), px(1.5));
    for (std::int64_t along = first; along < end; ++along) {
        const QRectF rect
            = QRectF(m_mapping.cell(m_scene.onSpan(along))).adjusted(inset, inset, -inset, -inset);
        m_painter.setPen(halo);
        m_painter.drawRect(rect);
        m_painter.setPen(pen);
        m_painter.drawRect(rect);
    }
}

void PixelGridPainter::paintCurrentPixel()
{
    if (!m_scene.currentPixel || !m_mapping.contains(*m_scene.currentPixel))
        return;
    const double inset = px(3);
    const QRectF rect
        = QRectF(m_mapping.cell(*m_scene.currentPixel)).adjusted(inset, inset, -inset, -inset);
    m_painter.setPen(QPen(m_style.palette.color(QPalette::Base), px(4)));
    m_painter.drawRect(rect);
    m_painter.setPen(QPen(colour(Sign::CurrentColumn), px(2)));
    m_painter.drawRect(rect);
}

void PixelGridPainter::paintSigns(const GridCell &cell)
{
    const double size = m_mapping.cellSize();
    if (cell.signs.empty() || size < px(12))
        return;
    const QFont font = [&] {
        QFont bold = fontOfSize(std::clamp(size / m_style.scale / 3.4, 7.0, 13.0));
        bold.setBold(true);
        return bold;
    }();
    const QFontMetricsF metrics(font);
    const double side = std::min(metrics.height() * 0.95, size / 2 - px(2)); // right of the values
    const QRectF rect = m_mapping.cell(cell.pixel);
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    m_painter.setFont(font);
    double top = rect.top() + px(1);
    for (const Sign sign : cell.signs) {
        const QRectF badge(rect.right() - side - px(1), top, side, side);
        m_painter.setPen(QPen(colour(sign), px(1)));
        m_painter.setBrush(m_style.palette.color(QPalette::Base));
        m_painter.drawRoundedRect(badge, px(2), px(2));
        m_painter.drawText(badge, Qt::AlignCenter, signGlyph(sign));
        top += side + px(1);
    }
    m_painter.restore();
}

} // namespace pixelplumb
