// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/tracedscene.h"
#include "widgets/pixelgridmapping.h"
#include "widgets/signs.h"

#include <QLineF>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace pixelplumb {

class DisplayOptions;
class Playhead;

/// One cell of the pixel grid.
struct GridCell {
    QPoint pixel;
    bool isInFrame = false;
    bool isBackground = false; ///< still shows the frame's background
    QRgb colour = 0;
    std::vector<Sign> signs; ///< difference, tie, clamp
};

/// An edge of the triangle in hand, in sample coordinates.
struct GridEdge {
    QLineF line;
    Sign sign = Sign::LowerEdge;
};

/// What the pixel grid shows at the playhead's position, taken from the trace and the truth once,
/// so that painting only draws. Coordinates are sample coordinates.
struct PixelGridScene {
    std::vector<GridCell> cells;
    std::vector<GridEdge> edges;
    std::optional<ColumnRecord> column; ///< in hand
    std::optional<QPoint> pixelInHand;
    std::optional<QPoint> picked;
    std::int64_t firstCandidate = 0; ///< rows of the column in hand that are not written yet
    std::int64_t endCandidate = 0;
    FrameOrigin origin = FrameOrigin::BottomLeft;
    Arithmetic arithmetic = Arithmetic::Exact;
    FillRule fillRule = FillRule::Closed;
};

/// The scene of the cells that a mapping shows. The playhead must hold a run.
PixelGridScene pixelGridScene(const Playhead &playhead, const DisplayOptions &options,
                              const PixelGridMapping &mapping);

/// The triangle that the step in hand works on; the first one before the first step; none in an
/// empty scene.
std::optional<std::size_t> triangleInHand(const Playhead &playhead);

} // namespace pixelplumb
