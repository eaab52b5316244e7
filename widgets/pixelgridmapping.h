// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"

#include <QMargins>
#include <QPoint>
#include <QPointF>
#include <QRect>
#include <QSize>

#include <optional>

namespace pixelplumb {

/// Where the pixel grid's cells are. All lengths are device pixels, so that every cell is a whole
/// number of them wide at every scale of the screen.
class PixelGridMapping {
public:
    PixelGridMapping() = default;
    /// `count` × `count` cells, as large as the area inside the margins allows, around a pixel of
    /// the frame in the middle cell.
    PixelGridMapping(const QSize &area, const QMargins &margins, int count, const QPoint &centre,
                     FrameOrigin origin);

    int count() const { return m_count; }
    int cellSize() const { return m_cellSize; }
    /// All cells.
    QRect grid() const { return m_grid; }

    int firstColumn() const { return m_first.x(); }
    int endColumn() const { return m_first.x() + m_count; }
    int firstRow() const { return m_first.y(); }
    int endRow() const { return m_first.y() + m_count; }
    bool contains(const QPoint &pixel) const;

    QRect cell(const QPoint &pixel) const;
    std::optional<QPoint> pixelAt(const QPointF &position) const;
    /// Where a point in sample coordinates is drawn: pixel (x, y) is sampled in the middle of its
    /// cell.
    QPointF position(double x, double y) const;
    /// The sample's own place, the middle of its cell.
    QPointF sample(const QPoint &pixel) const { return position(pixel.x(), pixel.y()); }

private:
    int m_count = 0;
    int m_cellSize = 0;
    QPoint m_first; ///< the pixel with the smallest coordinates
    FrameOrigin m_origin = FrameOrigin::BottomLeft;
    QRect m_grid;
};

} // namespace pixelplumb
