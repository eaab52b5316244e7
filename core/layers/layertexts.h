// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"

namespace pixelplumb {

/// The height of a line of text, and how far its baseline is below its top, in ems.
inline constexpr double lineHeight = 1.2;
inline constexpr double ascent = 0.9;

/// Paints texts on paper, in lines of a picture and in cells.
class LayerTexts {
public:
    LayerTexts(QPainter &painter, const LayerSurface &surface, Glyphs &glyphs)
        : m_painter(painter)
        , m_surface(surface)
        , m_glyphs(glyphs)
    {
    }

    /// Paints the texts in the cells of a drawing, all in one size: the widest fits its cell, and
    /// as many as possible stand below each other, clear of the samples. It returns what they are
    /// or, if that size is too small to read and nothing is painted, what there is no room for.
    QString paintCells(const LayerDrawing &drawing);
    void paintText(const QString &text, const QPointF &baseline, double em, LayerInk ink);
    void paintPaper(const QRectF &rect);

private:
    QPainter &m_painter;
    const LayerSurface &m_surface;
    Glyphs &m_glyphs;
};

} // namespace pixelplumb
