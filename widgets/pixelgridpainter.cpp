// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pixelgridpainter.h"

#include "widgets/blend.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double wideCell = 44; // three decimal numbers fit
constexpr double narrowCell = 26; // three pairs of hexadecimal digits fit
constexpr double lineCell = 6; // grid lines would hide smaller cells

constexpr float backgroundValueFade = 0.55F;

/// Black or white, whichever is read better: relative luminance of sRGB against its middle
/// (WCAG 2.1).
QColor textColourOn(QRgb colour)
{
    const auto linear = [](int byte) {
        const double share = byte / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    const double luminance = 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour))
        + 0.0722 * linear(qBlue(colour));
    return luminance > 0.179 ? Qt::black : Qt::white;
}

QString pairOfHexDigits(int byte) { return QString::number(byte + 0x100, 16).mid(1); }

} // namespace

PixelGridPainter::PixelGridPainter(QPainter &painter, const PixelGridStyle &style,
                                   const PixelGridMapping &mapping, const PixelGridScene &scene)
    : m_painter(painter)
    , m_style(style)
    , m_mapping(mapping)
    , m_scene(scene)
{
}

void PixelGridPainter::paint()
{
    for (const GridCell &cell : m_scene.cells)
        paintCell(cell);
    paintGridLines();
    for (const GridCell &cell : m_scene.cells)
        paintValue(cell);
    m_painter.save();
    m_painter.setClipRect(m_mapping.grid());
    paintEdges();
    paintPlumbLine();
    paintSamples();
    paintCandidates();
    paintPixelInHand();
    paintPickedPixel();
    paintSpan();
    for (const GridCell &cell : m_scene.cells)
        paintSigns(cell);
    m_painter.restore();
    paintAxes();
    paintSpanLabels();
}

QFont PixelGridPainter::fontOfSize(double logicalPixels) const
{
    QFont font = m_style.font;
    font.setPixelSize(std::max(1, int(px(logicalPixels))));
    return font;
}

void PixelGridPainter::drawHaloed(const QLineF &line, const QColor &colour, double width)
{
    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    m_painter.setPen(
        QPen(m_style.palette.color(QPalette::Base), px(width + 2), Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(line);
    m_painter.setPen(QPen(colour, px(width), Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(line);
    m_painter.restore();
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

void PixelGridPainter::paintGridLines()
{
    if (m_style.lines == GridLines::Hidden || m_mapping.cellSize() < px(lineCell))
        return;
    const QRect grid = m_mapping.grid();
    m_painter.setPen(QPen(QColor(128, 128, 128, 150), 1));
    for (int i = 0; i <= m_mapping.count(); ++i) {
        const int offset = i * m_mapping.cellSize();
        m_painter.drawLine(grid.left() + offset, grid.top(), grid.left() + offset,
                           grid.top() + grid.height());
        m_painter.drawLine(grid.left(), grid.top() + offset, grid.left() + grid.width(),
                           grid.top() + offset);
    }
}

void PixelGridPainter::paintValue(const GridCell &cell)
{
    const double size = m_mapping.cellSize();
    if (!cell.isInFrame || size < px(narrowCell))
        return;
    // In the left half of the cell, beside the sample point and the plumb line.
    const bool decimal = size >= px(wideCell);
    if (!decimal && cell.isBackground)
        return; // nothing to read there
    const QFont font = fontOfSize(std::min(12.0, size / m_style.scale / (decimal ? 4.6 : 3.4)));
    const QFontMetricsF metrics(font);
    QColor colour = textColourOn(cell.colour);
    if (cell.isBackground)
        colour = blended(colour, QColor::fromRgb(cell.colour), backgroundValueFade);
    m_painter.setPen(colour);
    m_painter.setFont(font);
    const QRectF rect = m_mapping.cell(cell.pixel);
    const double widest
        = metrics.horizontalAdvance(decimal ? QStringLiteral("000") : QStringLiteral("00"));
    const double right = rect.left() + px(decimal ? 3 : 2) + widest;
    const double lineHeight = (size - px(4)) / 3;
    const std::array<int, 3> bytes = {qRed(cell.colour), qGreen(cell.colour), qBlue(cell.colour)};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const QString text = decimal ? QString::number(bytes[i]) : pairOfHexDigits(bytes[i]);
        const double middle = rect.top() + px(2) + lineHeight * (double(i) + 0.5);
        m_painter.drawText(
            QPointF(right - metrics.horizontalAdvance(text), middle + metrics.capHeight() / 2),
            text);
    }
}

void PixelGridPainter::paintSamples()
{
    const double size = m_mapping.cellSize();
    if (size < px(lineCell * 2))
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

void PixelGridPainter::paintEdges()
{
    for (const GridEdge &edge : m_scene.edges) {
        // Far ends would leave the range in which painting is exact: cut to the grid's
        // surroundings.
        const QRectF around(m_mapping.firstColumn() - 2, m_mapping.firstRow() - 2,
                            m_mapping.count() + 4, m_mapping.count() + 4);
        double from = 0;
        double to = 1;
        const auto clip = [&](double start, double change, double low, double high) {
            if (change == 0) {
                if (start < low || start > high)
                    to = -1;
                return;
            }
            const double a = (low - start) / change;
            const double b = (high - start) / change;
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        };
        clip(edge.line.x1(), edge.line.dx(), around.left(), around.right());
        clip(edge.line.y1(), edge.line.dy(), around.top(), around.bottom());
        if (from > to)
            continue;
        const QPointF start = edge.line.pointAt(from);
        const QPointF end = edge.line.pointAt(to);
        drawHaloed(
            QLineF(m_mapping.position(start.x(), start.y()), m_mapping.position(end.x(), end.y())),
            colour(edge.sign), 1.5);
    }
}

void PixelGridPainter::paintPlumbLine()
{
    if (!m_scene.hasLine())
        return;
    const double at = double(m_scene.span->place.coordinate);
    const QRect grid = m_mapping.grid();
    const double x = m_mapping.position(at, 0).x();
    const double y = m_mapping.position(0, at).y();
    const QLineF line = m_scene.span->place.axis == SpanAxis::Row
        ? QLineF(grid.left(), y, grid.left() + grid.width(), y)
        : QLineF(x, grid.top(), x, grid.top() + grid.height());
    drawHaloed(line, colour(Sign::ColumnInHand), 1);
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
    QPen pen(colour(Sign::ColumnInHand), px(1.5));
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

void PixelGridPainter::paintPixelInHand()
{
    if (!m_scene.pixelInHand || !m_mapping.contains(*m_scene.pixelInHand))
        return;
    const double inset = px(3);
    const QRectF rect
        = QRectF(m_mapping.cell(*m_scene.pixelInHand)).adjusted(inset, inset, -inset, -inset);
    m_painter.setPen(QPen(m_style.palette.color(QPalette::Base), px(4)));
    m_painter.drawRect(rect);
    m_painter.setPen(QPen(colour(Sign::ColumnInHand), px(2)));
    m_painter.drawRect(rect);
}

void PixelGridPainter::paintPickedPixel()
{
    if (!m_scene.picked || !m_mapping.contains(*m_scene.picked))
        return;
    const QRectF rect = QRectF(m_mapping.cell(*m_scene.picked));
    m_painter.setPen(QPen(m_style.palette.color(QPalette::Base), px(4)));
    m_painter.drawRect(rect);
    m_painter.setPen(QPen(colour(Sign::PickedPixel), px(2)));
    m_painter.drawRect(rect);
}

void PixelGridPainter::paintSigns(const GridCell &cell)
{
    const double size = m_mapping.cellSize();
    if (cell.signs.empty() || size < px(12))
        return;
    const QFont font = [&] {
        QFont bold = fontOfSize(std::clamp(size / m_style.scale / 2.6, 8.0, 13.0));
        bold.setBold(true);
        return bold;
    }();
    const QFontMetricsF metrics(font);
    const double side = metrics.height() * 0.95;
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
