// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"

#include <span>
#include <vector>

namespace pixelplumb {

/// Paints the texts of a drawing, each on paper.
class LayerTexts {
public:
    LayerTexts(QPainter &painter, const LayerSurface &surface, Glyphs &glyphs)
        : m_painter(painter)
        , m_surface(surface)
        , m_glyphs(glyphs)
    {
    }

    /// All in one size, in which the widest fits its cell and the most stand below each other;
    /// nothing where that is too small to read.
    void paintCells(std::span<const LayerDrawing::CellText> texts);
    /// Beside its place, on the first side where no other label stands; nothing where the place is
    /// far out of view.
    void paint(const LayerDrawing::Label &label);

private:
    void paintText(const QString &text, const QPointF &baseline, double em, LayerInk ink);
    void paintPaper(const QRectF &rect);

    QPainter &m_painter;
    const LayerSurface &m_surface;
    Glyphs &m_glyphs;
    std::vector<QRectF> m_labels; ///< where they stand so far
};

} // namespace pixelplumb
