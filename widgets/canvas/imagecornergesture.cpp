// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/imagecornergesture.h"

#include "widgets/canvas/imageedit.h"
#include "widgets/canvas/imagehandles.h"

namespace pixelplumb {

MoveImageCornerGesture::MoveImageCornerGesture(const CanvasView &view, const CanvasSources &sources,
                                               std::size_t corner, const QPointF &press)
    : MovePointGesture(view, press, imageInView(sources)->corners[corner])
    , m_sources(sources)
    , m_corner(corner)
    , m_before(sources.options->affineImage())
    , m_image(*imageInView(sources))
    , m_drag(sources.document->newDrag())
{
}

void MoveImageCornerGesture::movePoint(const LatticePoint &place)
{
    moveImageCorner(m_sources, m_image, m_corner, place, m_drag);
}

void MoveImageCornerGesture::cancel()
{
    if (hasMoved() && m_sources.options->affineImage() != m_before)
        m_sources.document->undoStack()->push(new ImageEdit(*m_sources.options, m_before, m_drag));
}

} // namespace pixelplumb
