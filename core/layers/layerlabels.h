// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layertexts.h"

#include <QLineF>

#include <optional>

namespace pixelplumb {

/// Finds places for the names in a picture, then paints them all: the lines from names to what they
/// name below, so that none strikes a name through.
class LayerLabels {
public:
    /// Names keep clear of what is taken.
    LayerLabels(QPainter &painter, const LayerSurface &surface, Glyphs &glyphs,
                std::span<const QRectF> taken)
        : m_painter(painter)
        , m_surface(surface)
        , m_glyphs(glyphs)
        , m_taken(taken)
    {
    }

    /// From now on, of these instead.
    void keepClearOf(std::span<const QRectF> taken) { m_taken = taken; }

    /// Where nothing else stands, as near to its place as can be, with a line to it when it is not
    /// beside it, else beside one of its other places; nowhere when these are far out of view.
    void place(const LayerDrawing::Label &label);
    /// The text of a bar, on the side of it that `away` points to or on the other one, never nearer
    /// to another bar: of two bars in a row each text stands at its own outer end.
    void placeBeside(const QString &text, const QRectF &bar, const QPointF &away,
                     std::span<const QRectF> otherBars, LayerInk ink);
    void paint();
    /// How many had no room.
    std::size_t omitted() const { return m_omitted; }
    /// Where names stand.
    std::vector<QRectF> places() const;

private:
    struct Placed {
        QString text;
        QRectF rect;
        QLineF leader; ///< a point where the name stands beside its anchor
        LayerInk ink = LayerInk::Mark;
    };

    bool isNearView(const QPointF &anchor) const;
    /// Whether all of it is on the side of the border, if there is one.
    bool isWithin(const QRectF &rect, const std::optional<LayerDrawing::HalfPlane> &side) const;
    QSizeF sizeOf(const QString &text);
    /// Takes the first of the places that is free, if possible one with an unstruck leader. False
    /// where none is.
    bool placeAt(const QString &text, const QPointF &anchor, LayerInk ink,
                 std::span<const QRectF> rects);
    /// Whether it covers no other name and nothing that is taken.
    bool isFree(const QRectF &rect) const;
    /// Whether its line and those of others pass by all names.
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
