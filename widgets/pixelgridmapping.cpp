// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pixelgridmapping.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

PixelGridMapping::PixelGridMapping(const QSize &area, const QMargins &margins, int count,
                                   const QPoint &centre, FrameOrigin origin)
    : m_count(count)
    , m_first(centre - QPoint(count / 2, count / 2))
    , m_origin(origin)
{
    const QRect inside = QRect(QPoint(0, 0), area).marginsRemoved(margins);
    m_cellSize = std::max(1, std::min(inside.width(), inside.height()) / count);
    const int side = m_cellSize * count;
    m_grid = QRect(inside.left(), inside.top() + std::max(0, (inside.height() - side) / 2), side,
                   side);
}

bool PixelGridMapping::contains(const QPoint &pixel) const
{
    return pixel.x() >= firstColumn() && pixel.x() < endColumn() && pixel.y() >= firstRow()
        && pixel.y() < endRow();
}

QRect PixelGridMapping::cell(const QPoint &pixel) const
{
    const int column = pixel.x() - m_first.x();
    const int row = pixel.y() - m_first.y();
    const int line = m_origin == FrameOrigin::BottomLeft ? m_count - 1 - row : row;
    return {m_grid.left() + column * m_cellSize, m_grid.top() + line * m_cellSize, m_cellSize,
            m_cellSize};
}

std::optional<QPoint> PixelGridMapping::pixelAt(const QPointF &position) const
{
    if (m_count == 0)
        return std::nullopt;
    const int column = int(std::floor((position.x() - m_grid.left()) / m_cellSize));
    const int line = int(std::floor((position.y() - m_grid.top()) / m_cellSize));
    if (column < 0 || column >= m_count || line < 0 || line >= m_count)
        return std::nullopt;
    const int row = m_origin == FrameOrigin::BottomLeft ? m_count - 1 - line : line;
    return m_first + QPoint(column, row);
}

QPointF PixelGridMapping::position(double x, double y) const
{
    const double column = x - m_first.x() + 0.5;
    const double row = y - m_first.y() + 0.5;
    const double line = m_origin == FrameOrigin::BottomLeft ? m_count - row : row;
    return {m_grid.left() + column * m_cellSize, m_grid.top() + line * m_cellSize};
}

} // namespace pixelplumb
