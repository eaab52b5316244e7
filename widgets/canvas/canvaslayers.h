// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/ahead.h"
#include "widgets/canvas/canvasscene.h"

#include <memory>

namespace pixelplumb {

struct LayerView;

/// What the layers that are switched on draw of the moment in view. It is collected anew when one
/// of these changes, not at every move of the pointer.
class CanvasLayers {
public:
    /// Nothing while the run is not that of the scene, and where the truth stands in the frame's
    /// place.
    void addTo(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view);

private:
    /// What the drawing follows from.
    struct Moment {
        std::shared_ptr<const TracedScene> traced;
        std::size_t position = 0;
        QStringList layers;
        ViewMapping mapping;
        QRectF area;
        std::optional<QPoint> picked;
        std::optional<AffineImage> image;
        Ahead ahead = Ahead::Shown;

        friend bool operator==(const Moment &, const Moment &) = default;
    };

    Moment m_moment;
    LayerDrawing m_drawing;
};

} // namespace pixelplumb
