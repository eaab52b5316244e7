// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"

#include <span>
#include <vector>

namespace pixelplumb {

/// Paints the texts of a drawing, each on paper.
class LayerTexts {
public:
    /// Labels keep clear of what is taken.
    LayerTexts(QPainter &painter, const LayerSurface &surface, Glyphs &glyphs,
               std::span<const QRectF> taken = {})
        : m_painter(painter)
        , m_surface(surface)
        , m_glyphs(glyphs)
        , m_taken(taken.begin(), taken.end())
    {
    }

    /// All in one size, in which the widest fits its cell and the most stand below each other;
    /// nothing where that is too small to read, and then it returns what is to be said of it.
    QString paintCells(std::span<const LayerDrawing::CellText> texts);
    enum class Room { Found, None };
    /// Where nothing else stands, as near to its place as can be, with a line to it when it is not
    /// beside it; nothing where there is no room, nor where the place is far out of view.
    Room paint(const LayerDrawing::Label &label);
    /// What was taken before, and behind it where labels stand.
    const std::vector<QRectF> &taken() const { return m_taken; }

private:
    void paintText(const QString &text, const QPointF &baseline, double em, LayerInk ink);
    void paintPaper(const QRectF &rect);
    void paintLeader(const QLineF &leader, LayerInk ink);

    QPainter &m_painter;
    const LayerSurface &m_surface;
    Glyphs &m_glyphs;
    std::vector<QRectF> m_taken; ///< by labels and by what else stands in the picture
};

} // namespace pixelplumb
