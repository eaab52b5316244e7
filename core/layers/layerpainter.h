// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/layers/glyphs.h"
#include "core/layers/layerdrawing.h"

#include <QColor>
#include <QRectF>
#include <QStringList>
#include <QTransform>

#include <span>
#include <vector>

class QPainter;

namespace pixelplumb {

/// Whether layers are painted on light paper or on dark.
enum class LayerTone { Light, Dark };

/// From the Okabe–Ito set, like the window's signs, so that text in it keeps 4.5:1 on the paper.
QColor colourOf(LayerInk ink, LayerTone tone);
/// The background of lines and texts, which stay readable on every colour that a frame may hold.
QColor paperOf(LayerTone tone);

/// From sample coordinates to those of a picture of the frame, whose upper left corner is at
/// `corner` and whose pixels are squares of `cell`: y is flipped if the frame's grows upward.
QTransform pictureTransform(const FrameSpec &frame, const QPointF &corner, double cell);

/// Where layers are painted.
struct LayerSurface {
    QTransform fromSamples; ///< pictureTransform(): a shift, a scale and at most a mirror
    QRectF view; ///< the part of the paint device that shows the frame
    LayerTone tone = LayerTone::Light;
};

/// Paints the drawings of layers, for the window and the command line alike: lines have a casing,
/// texts a paper background. It returns notes to show with the picture: what the numbers in the
/// cells are, and what had no room. It keeps the glyphs that it has painted.
class LayerPainter {
public:
    /// All of a drawing.
    QStringList paint(QPainter &painter, const LayerDrawing &drawing, const LayerSurface &surface);
    /// What lies below the lines and signs of a window: areas, plain edges, which the window
    /// outlines itself, and samples.
    void paintGround(QPainter &painter, const LayerDrawing &drawing, const LayerSurface &surface);
    /// The numbers in the cells: painted over a window's own lines, which would strike them
    /// through.
    QStringList paintNumbers(QPainter &painter, const LayerDrawing &drawing,
                             const LayerSurface &surface);
    /// What would be hidden below them: everything else but texts.
    void paintMarks(QPainter &painter, const LayerDrawing &drawing, const LayerSurface &surface);
    /// Where the measures of a drawing are, in the paint device: they take room like names.
    static std::vector<QRectF> measurePlaces(const LayerDrawing &drawing,
                                             const LayerSurface &surface);
    /// These and pieces of all lines, which a note should leave visible.
    static std::vector<QRectF> figurePlaces(const LayerDrawing &drawing,
                                            const LayerSurface &surface);
    /// Paints labels and the texts of measures, clear of each other, of points and bands and of
    /// `taken`, in the paint device.
    QStringList paintLabels(QPainter &painter, const LayerDrawing &drawing,
                            const LayerSurface &surface, std::span<const QRectF> taken);
    /// Where the last painted labels are, in the paint device.
    const std::vector<QRectF> &labels() const { return m_labels; }

private:
    Glyphs m_glyphs;
    std::vector<QRectF> m_labels;
};

} // namespace pixelplumb
