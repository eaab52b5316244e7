// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affineimage.h"
#include "widgets/canvas/canvasgesture.h"

namespace pixelplumb {

struct CanvasSources;

/// Moves a corner of the affine map's image; the scene stays as it is.
class MoveImageCornerGesture final : public MovePointGesture {
public:
    MoveImageCornerGesture(const CanvasView &view, const CanvasSources &sources, std::size_t corner,
                           const QPointF &press);
    void cancel() override;

protected:
    void movePoint(const LatticePoint &place) override;

private:
    const CanvasSources &m_sources;
    std::size_t m_corner;
    std::optional<AffineImage> m_before; ///< the requested image
    AffineImage m_image; ///< at the press
    int m_drag;
};

} // namespace pixelplumb
