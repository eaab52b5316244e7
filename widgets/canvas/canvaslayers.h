// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/ahead.h"
#include "widgets/canvas/canvasscene.h"

#include <memory>

namespace pixelplumb {

struct LayerView;

/// What the enabled layers draw at the shown moment. It is collected anew when one of these
/// changes, not at every move of the pointer.
class CanvasLayers {
public:
    /// Adds nothing while the run is not the scene's own, and while the truth is shown instead of
    /// the frame.
    void addTo(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view);

private:
    /// What the drawing depends on.
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
