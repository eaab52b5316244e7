// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/pixelgridmapping.h"

#include <algorithm>

namespace pixelplumb {

PixelGridMapping::PixelGridMapping(const QSize &area, const QMargins &margins,
                                   const CellCount &count, const QPoint &centre, FrameOrigin origin)
{
    const QRect inside = QRect(QPoint(0, 0), area).marginsRemoved(margins);
    const int cellSize
        = std::max(1, std::min(inside.width() / count.columns, inside.height() / count.rows));
    const int above = std::max(0, (inside.height() - cellSize * count.rows) / 2);
    FrameSpec cells;
    cells.width = count.columns;
    cells.height = count.rows;
    cells.firstColumn = centre.x() - count.columns / 2;
    cells.firstRow = centre.y() - count.rows / 2;
    cells.origin = origin;
    m_view = ViewMapping(cells, {cellSize, 1}, inside.topLeft() + QPoint(0, above));
}

bool PixelGridMapping::contains(const QPoint &pixel) const
{
    return pixel.x() >= firstColumn() && pixel.x() < endColumn() && pixel.y() >= firstRow()
        && pixel.y() < endRow();
}

} // namespace pixelplumb
