// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/performancecachelines.h"

#include "widgets/look/blend.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/signs.h"

#include <QPainter>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int gap = 16; // between the two walks
constexpr int mostColumns = 16;
constexpr int mostRows = 8;
constexpr double largestCell = 16;
constexpr int setsPerRow = 32;
constexpr double setHeight = 10;
constexpr double setSpacing = 2;

} // namespace

PerformanceCacheLines::PerformanceCacheLines(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("performanceCacheLines"));
    setAccessibleName(tr("Cache lines that a column walk and a strip walk touch"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void PerformanceCacheLines::showStrip(const PixelPlaces &places, const PixelBlock &block,
                                      const DataCache &cache)
{
    m_places = places;
    m_block = block;
    m_cache = cache;
    m_columnWalk = walk(places, block, WalkOrder::UpColumns, cache);
    m_stripWalk = walk(places, block, WalkOrder::AlongRows, cache);
    setAccessibleDescription(
        tr("Up the columns: %1 changes of line, %2 misses. Along the strip: %3 changes, %4 misses. "
           "%5 lines fall on %6 of %7 sets.")
            .arg(m_columnWalk.changes)
            .arg(m_columnWalk.misses)
            .arg(m_stripWalk.changes)
            .arg(m_stripWalk.misses)
            .arg(m_stripWalk.lines)
            .arg(m_stripWalk.usedSets())
            .arg(m_cache.sets));
    updateGeometry();
    update();
}

QSize PerformanceCacheLines::sizeHint() const
{
    const int line = fontMetrics().lineSpacing();
    const int setRows = (m_cache.sets + setsPerRow - 1) / setsPerRow;
    return {440,
            int(4 * line + largestCell * shownRows() + 16 + line + 4
                + setRows * (setHeight + setSpacing))};
}

QSize PerformanceCacheLines::minimumSizeHint() const { return {240, sizeHint().height()}; }

int PerformanceCacheLines::shownColumns() const
{
    return int(std::min<std::int64_t>(m_block.columns, mostColumns));
}

int PerformanceCacheLines::shownRows() const
{
    return int(std::min<std::int64_t>(m_block.rows, mostRows));
}

double PerformanceCacheLines::cellSide() const
{
    return std::min(largestCell, (width() - gap) / 2.0 / mostColumns);
}

void PerformanceCacheLines::paintEvent(QPaintEvent *)
{
    if (m_block.columns == 0 || m_block.rows == 0)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double half = (width() - gap) / 2.0;
    const int line = fontMetrics().lineSpacing();
    const double walkHeight = 4 * line + cellSide() * shownRows() + 8;
    paintWalk(painter, {0, 0, half, walkHeight}, WalkOrder::UpColumns);
    paintWalk(painter, {half + gap, 0, half, walkHeight}, WalkOrder::AlongRows);
    paintSets(painter, {0, walkHeight + 8, double(width()), height() - walkHeight - 8});
}

void PerformanceCacheLines::paintWalk(QPainter &painter, const QRectF &area, WalkOrder order) const
{
    const double line = fontMetrics().lineSpacing();
    const bool isUp = order == WalkOrder::UpColumns;
    const CacheWalk &taken = isUp ? m_columnWalk : m_stripWalk;
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignLeft,
                     isUp ? tr("column walk") : tr("strip walk"));
    painter.setFont(font());

    const double side = cellSide();
    const QPointF corner(area.left(), area.top() + line + 4 + side * shownRows());
    paintLines(painter, corner, side);
    paintPath(painter, corner, side, order);

    const QStringList counts
        = {tr("%1 changes of line", nullptr, int(taken.changes)).arg(groupedText(taken.changes)),
           tr("%1 misses", nullptr, int(taken.misses)).arg(groupedText(taken.misses)),
           tr("%1 lines in all", nullptr, int(taken.lines)).arg(groupedText(taken.lines))};
    painter.setPen(palette().color(QPalette::WindowText));
    double top = corner.y() + 4;
    for (const QString &count : counts) {
        painter.drawText(QRectF(area.left(), top, area.width(), line), Qt::AlignLeft, count);
        top += line;
    }
}

/// The lowest rows, cut where one cache line ends and the next begins.
void PerformanceCacheLines::paintLines(QPainter &painter, const QPointF &corner, double side) const
{
    const QColor base = palette().color(QPalette::Base);
    const QColor tinted = blended(base, palette().color(QPalette::Highlight), 0.28F);
    const auto lineAt = [this](int column, int row) {
        return m_places.address(m_block.firstColumn + column, m_block.firstRow + row)
            / std::uint64_t(m_cache.lineBytes);
    };
    painter.setPen(Qt::NoPen);
    for (int row = 0; row < shownRows(); ++row) {
        int first = 0;
        while (first < shownColumns()) {
            int end = first + 1;
            while (end < shownColumns() && lineAt(end, row) == lineAt(first, row))
                ++end;
            const QRectF rect(corner.x() + first * side, corner.y() - (row + 1) * side,
                              (end - first) * side, side);
            painter.setBrush(tinted);
            painter.drawRoundedRect(rect.adjusted(0.5, 1, -0.5, -1), 2, 2);
            first = end;
        }
    }
}

bool PerformanceCacheLines::changesLine(WalkOrder order, int column, int row) const
{
    const auto lineAt = [this](std::int64_t x, std::int64_t y) {
        return m_places.address(m_block.firstColumn + x, m_block.firstRow + y)
            / std::uint64_t(m_cache.lineBytes);
    };
    if (column == 0 && row == 0)
        return true;
    const bool isUp = order == WalkOrder::UpColumns;
    const std::int64_t lastX
        = isUp ? (row > 0 ? column : column - 1) : (column > 0 ? column - 1 : m_block.columns - 1);
    const std::int64_t lastY
        = isUp ? (row > 0 ? row - 1 : m_block.rows - 1) : (column > 0 ? row : row - 1);
    return lineAt(column, row) != lineAt(lastX, lastY);
}

void PerformanceCacheLines::paintPath(QPainter &painter, const QPointF &corner, double side,
                                      WalkOrder order) const
{
    const bool isUp = order == WalkOrder::UpColumns;
    const auto centre = [&](int column, int row) {
        return QPointF(corner.x() + (column + 0.5) * side, corner.y() - (row + 0.5) * side);
    };
    const QColor mark = signColour(Sign::ColumnInHand, palette());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mark, 1));
    const int runs = isUp ? shownColumns() : shownRows();
    for (int run = 0; run < runs; ++run) {
        if (isUp)
            painter.drawLine(centre(run, 0), centre(run, shownRows() - 1));
        else
            painter.drawLine(centre(0, run), centre(shownColumns() - 1, run));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark);
    const double radius = std::max(1.5, side / 6);
    for (int column = 0; column < shownColumns(); ++column) {
        for (int row = 0; row < shownRows(); ++row) {
            if (changesLine(order, column, row))
                painter.drawEllipse(centre(column, row), radius, radius);
        }
    }
}

void PerformanceCacheLines::paintSets(QPainter &painter, const QRectF &area) const
{
    const double line = fontMetrics().lineSpacing();
    const int most = *std::ranges::max_element(m_stripWalk.linesOfSet);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignLeft,
                     tr("%1 of %2 sets, at most %3 lines in one (%4 fit)", nullptr, most)
                         .arg(m_stripWalk.usedSets())
                         .arg(m_cache.sets)
                         .arg(most)
                         .arg(m_cache.ways));
    const QColor base = palette().color(QPalette::Base);
    const QColor fits = palette().color(QPalette::Highlight);
    const QColor over = signColour(Sign::Extra, palette());
    const int columns = std::min(setsPerRow, m_cache.sets);
    const double step = (area.width() + setSpacing) / columns;
    painter.setPen(Qt::NoPen);
    for (int set = 0; set < m_cache.sets; ++set) {
        const int lines = m_stripWalk.linesOfSet[std::size_t(set)];
        const QRectF cell(area.left() + set % columns * step,
                          area.top() + line + 4 + set / columns * (setHeight + setSpacing),
                          step - setSpacing, setHeight);
        painter.setBrush(blended(base, palette().color(QPalette::Mid), 0.5F));
        painter.drawRect(cell);
        // As high as the set is full; beyond that another colour, and a line across the top.
        const double share = std::min(1.0, double(lines) / m_cache.ways);
        const bool isOver = lines > m_cache.ways;
        painter.setBrush(isOver ? over : fits);
        painter.drawRect(QRectF(cell.left(), cell.bottom() - share * setHeight, cell.width(),
                                share * setHeight));
        if (isOver) {
            painter.setBrush(palette().color(QPalette::WindowText));
            painter.drawRect(QRectF(cell.left(), cell.top(), cell.width(), 2));
        }
    }
}

} // namespace pixelplumb
