// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/viewmapping.h"

#include <QMargins>
#include <QPoint>
#include <QPointF>
#include <QRect>
#include <QSize>

#include <optional>

namespace pixelplumb {

/// How many cells are shown; a single number means as many in both directions.
struct CellCount {
    int columns = 1;
    int rows = 1;

    CellCount(int side)
        : columns(side)
        , rows(side)
    {
    }
    CellCount(int across, int up)
        : columns(across)
        , rows(up)
    {
    }
};

/// Where the pixel grid's cells are: a mapping whose small frame is just these cells. All lengths
/// are device pixels, so that every cell is a whole number of them wide at any screen scale.
class PixelGridMapping {
public:
    /// Makes cells as large as the area inside the margins allows, with the pixel `centre` in the
    /// middle cell.
    PixelGridMapping(const QSize &area, const QMargins &margins, const CellCount &count,
                     const QPoint &centre, FrameOrigin origin);

    int columns() const { return m_view.frame().width; }
    int rows() const { return m_view.frame().height; }
    int cellSize() const { return m_view.zoom().devicePixels; }
    /// All cells.
    QRect grid() const { return m_view.devicePicture(); }
    /// The grid's mapping in logical pixels of a screen.
    ViewMapping onScreen(double devicePixelRatio) const
    {
        return {m_view.frame(), m_view.zoom(), m_view.origin(), devicePixelRatio};
    }

    int firstColumn() const { return m_view.frame().firstColumn; }
    int endColumn() const { return firstColumn() + columns(); }
    int firstRow() const { return m_view.frame().firstRow; }
    int endRow() const { return firstRow() + rows(); }
    bool contains(const QPoint &pixel) const;

    QRect cell(const QPoint &pixel) const { return m_view.deviceCellOf(pixel); }
    std::optional<QPoint> pixelAt(const QPointF &position) const
    {
        return m_view.pixelAt(position);
    }
    /// Where a point in sample coordinates is drawn: pixel (x, y) is sampled in the middle of its
    /// cell.
    QPointF position(double x, double y) const { return m_view.positionOf(x, y); }
    /// A pixel's sample point, the middle of its cell.
    QPointF sample(const QPoint &pixel) const { return position(pixel.x(), pixel.y()); }

private:
    ViewMapping m_view;
};

} // namespace pixelplumb
