// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "widgets/look/framepainter.h"
#include "widgets/look/viewmapping.h"

#include <QMargins>
#include <QPoint>
#include <QPointF>
#include <QRect>
#include <QSize>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace pixelplumb {

class DisplayOptions;
class Playhead;

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

/// One cell of the pixel grid.
struct GridCell {
    QPoint pixel;
    bool isInFrame = false;
    bool isBackground = false; ///< still shows the frame's background
    QRgb colour = 0;
    std::vector<Sign> signs; ///< difference, tie, clamp
};

/// What the pixel grid shows at the playhead's position, taken once from the trace and the truth,
/// so that painting only draws. Coordinates are sample coordinates.
struct PixelGridScene {
    std::vector<GridCell> cells;
    std::optional<std::array<LatticePoint, 3>> triangle; ///< the current one
    EdgeRoles roles = {}; ///< of the triangle's edges
    std::optional<SpanRecord> span; ///< the current one
    /// Names the span whose bounds are shown beside the cells, "column 27": the current span, which
    /// need not be the picked pixel's; empty where it is not among the cells.
    QString boundsOf;
    std::optional<QPoint> currentPixel;
    std::optional<QPoint> picked;
    std::int64_t firstCandidate = 0; ///< samples along the current span not decided yet
    std::int64_t endCandidate = 0;
    FrameOrigin origin = FrameOrigin::BottomLeft;
    Arithmetic arithmetic = Arithmetic::Exact;
    FillRule fillRule = FillRule::Closed;
    /// With area coverage the span's rows are not just those that its bounds cover.
    Antialiasing antialiasing = Antialiasing::None;

    /// The pixel at a place along the current span, a column or a row.
    QPoint onSpan(std::int64_t along) const
    {
        const auto at = int(span->place.coordinate);
        return span->place.axis == SpanAxis::Row ? QPoint(int(along), at) : QPoint(at, int(along));
    }
    bool hasLine() const { return span && span->place.axis != SpanAxis::Free; }
};

/// The scene of the cells that a mapping shows. The playhead must have a run.
PixelGridScene pixelGridScene(const Playhead &playhead, const DisplayOptions &options,
                              const PixelGridMapping &mapping);

/// The triangle of the current step; the first triangle before the first step; none where the scene
/// has no triangle or the step belongs to a shape.
std::optional<std::size_t> currentTriangle(const Playhead &playhead);

} // namespace pixelplumb
