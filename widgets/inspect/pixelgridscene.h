// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "widgets/look/framepainter.h"
#include "widgets/look/viewmapping.h"

#include <QtCore>

#include <array>
#include <optional>
#include <vector>

namespace pixelplumb {

class DisplayOptions;
class Playhead;

/// Where the pixel grid's cells are: a mapping whose frame is just these cells, with the pixel
/// `centre` in the middle one, as large as the area inside the margins allows. Every cell is a
/// whole number of device pixels wide.
ViewMapping pixelGridMapping(const QSize &area, const QMargins &margins, const QSize &cells,
                             const QPoint &centre, FrameOrigin origin, double devicePixelRatio = 1);

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
    /// How the span's first and last sample follow from its bounds, "⌈y_B⌉" and "⌊y_T⌋"; where the
    /// area decides, only their names.
    std::array<QString, 2> roundings;
    bool areBoundsExact = false; ///< in a run that computes others, or none, in floats

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
                              const ViewMapping &mapping);

/// The triangle of the current step; the first triangle before the first step; none where the scene
/// has no triangle or the step belongs to a shape.
std::optional<std::size_t> currentTriangle(const Playhead &playhead);

} // namespace pixelplumb
