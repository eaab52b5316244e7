// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/cachewalk.h"

#include <QWidget>

namespace pixelplumb {

/// The picture of the cache lines that a column walk and a strip walk touch in the same pixels: the
/// two walks with a dot wherever another line is asked for, and the cache's sets with as many lines
/// as fall on each. Row 0 is at the bottom.
class PerformanceCacheLines : public QWidget {
    Q_OBJECT

public:
    explicit PerformanceCacheLines(QWidget *parent = nullptr);

    /// `block`: a strip from the frame's lowest row to its highest one.
    void showStrip(const PixelPlaces &places, const PixelBlock &block, const DataCache &cache);

    const CacheWalk &columnWalk() const { return m_columnWalk; }
    const CacheWalk &stripWalk() const { return m_stripWalk; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    int shownColumns() const;
    int shownRows() const;
    double cellSide() const;
    void paintWalk(QPainter &painter, const QRectF &area, WalkOrder order) const;
    void paintLines(QPainter &painter, const QPointF &corner, double side) const;
    void paintPath(QPainter &painter, const QPointF &corner, double side, WalkOrder order) const;
    void paintSets(QPainter &painter, const QRectF &area) const;
    bool changesLine(WalkOrder order, int column, int row) const;

    PixelPlaces m_places{0, 0};
    PixelBlock m_block;
    DataCache m_cache;
    CacheWalk m_columnWalk;
    CacheWalk m_stripWalk;
};

} // namespace pixelplumb
