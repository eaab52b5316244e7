// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvas/canvasscene.h"

#include <QtCore>

#include <cstddef>
#include <memory>

namespace pixelplumb {

class Playhead;
struct CanvasHand;
struct CanvasSources;
struct TracedScene;

/// The text beside the pointer about the pixel under it, at the playhead's moment: the primitive
/// that painted it last, and that triangle's nearest edge; where nothing is painted, the edge that
/// keeps the pixel out of the nearest triangle. Distances are perpendicular to the edge's line.
class PointerReadout {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::PointerReadout)

public:
    /// "(27, 19) #a06f30" and "triangle 0 · 3.25 px from L₀₂", a line each; before them the place
    /// of the vertex that a click would place, where that is no pixel. No painter while the truth
    /// is shown; the place alone without a run.
    QString text(const QPoint &pixel, const CanvasSources &sources, const CanvasHand &hand);

private:
    QString owner(const QPoint &pixel, const Playhead &playhead);

    // What the text was made for. The weak pointer does not keep an old run in memory.
    QPoint m_pixel;
    std::size_t m_position = 0;
    std::weak_ptr<const TracedScene> m_traced;
    QString m_text;
};

/// What a screen reader says of the current vertex, image corner or pixel.
QString spokenState(const CanvasSources &sources, const CanvasHand &hand);

/// Exposes the current pixel or vertex to screen readers as a Canvas's value. Harmless when called
/// again.
void installCanvasAccessible();

} // namespace pixelplumb
