// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/imagecornergesture.h"

#include "widgets/canvas/imagehandles.h"

namespace pixelplumb {

MoveImageCornerGesture::MoveImageCornerGesture(const CanvasView &view, const CanvasSources &sources,
                                               std::size_t corner, const QPointF &press)
    : MovePointGesture(view, press, imageInView(sources)->corners[corner])
    , m_sources(sources)
    , m_corner(corner)
    , m_before(sources.options->affineImage())
    , m_image(*imageInView(sources))
{
}

void MoveImageCornerGesture::movePoint(const LatticePoint &place)
{
    moveImageCorner(m_sources, m_image, m_corner, place);
}

void MoveImageCornerGesture::cancel() { m_sources.options->setAffineImage(m_before); }

} // namespace pixelplumb
