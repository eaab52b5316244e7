// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layertexts.h"

#include <QLineF>

#include <optional>

namespace pixelplumb {

/// Finds places for the names in a picture, then paints them all, with the lines from names to what
/// they name underneath, so that none strikes a name through.
class LayerLabels {
public:
    /// Names keep clear of `taken`.
    LayerLabels(QPainter &painter, const LayerSurface &surface, Glyphs &glyphs,
                std::span<const QRectF> taken)
        : m_painter(painter)
        , m_surface(surface)
        , m_glyphs(glyphs)
        , m_taken(taken)
    {
    }

    /// From now on keeps clear of these instead.
    void keepClearOf(std::span<const QRectF> taken) { m_taken = taken; }

    /// Places a label where nothing else is, as near to its place as can be, with a line to it if
    /// they are not adjacent, else beside one of its other places; nowhere if these are far out of
    /// view.
    void place(const LayerDrawing::Label &label);
    /// Places the text of a bar on the side that `away` points to or on the other one, never nearer
    /// to another bar: of two bars in a row each has its text at its own outer end.
    void placeBeside(const QString &text, const QRectF &bar, const QPointF &away,
                     std::span<const QRectF> otherBars, LayerInk ink);
    void paint();
    /// How many labels had no room.
    std::size_t omitted() const { return m_omitted; }
    /// Where names stand.
    std::vector<QRectF> places() const;

private:
    struct Placed {
        QString text;
        QRectF rect;
        QLineF leader; ///< a point if the name is adjacent to its anchor
        LayerInk ink = LayerInk::Mark;
    };

    bool isNearView(const QPointF &anchor) const;
    /// Whether all of it is on the side of the border, if there is one.
    bool isWithin(const QRectF &rect, const std::optional<LayerDrawing::HalfPlane> &side) const;
    QSizeF sizeOf(const QString &text);
    /// Takes the first free place, if possible one with an unstruck leader. False if none is free.
    bool placeAt(const QString &text, const QPointF &anchor, LayerInk ink,
                 std::span<const QRectF> rects);
    /// Whether it covers no other name and nothing that is taken.
    bool isFree(const QRectF &rect) const;
    /// Whether no leader, its own or another's, crosses a name.
    bool isUnstruck(const Placed &label) const;
    void paintLeader(const Placed &label);

    QPainter &m_painter;
    const LayerSurface &m_surface;
    Glyphs &m_glyphs;
    std::span<const QRectF> m_taken;
    std::vector<Placed> m_placed;
    std::size_t m_omitted = 0;
};

} // namespace pixelplumb
