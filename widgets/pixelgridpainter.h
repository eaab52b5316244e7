// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/pixelgridscene.h"

#include <QFont>
#include <QPalette>

class QPainter;

namespace pixelplumb {

enum class GridLines { Hidden, Shown };

/// How the pixel grid is drawn: palette, font and pen widths in device pixels.
struct PixelGridStyle {
    QPalette palette;
    QFont font; ///< its size in device pixels
    double scale = 1; ///< device pixels per logical pixel
    GridLines lines = GridLines::Shown;
};

/// The room that axis labels and the names of y_B and y_T need around the cells.
QMargins pixelGridMargins(const PixelGridStyle &style, const QSize &area, int largestRowDigits);

/// Draws a scene through a painter that works in device pixels.
class PixelGridPainter {
public:
    PixelGridPainter(QPainter &painter, const PixelGridStyle &style,
                     const PixelGridMapping &mapping, const PixelGridScene &scene);

    void paint();

private:
    void paintCell(const GridCell &cell);
    void paintValue(const GridCell &cell);
    void paintSigns(const GridCell &cell);
    void paintSamples();
    void paintGridLines();
    void paintEdges();
    void paintPlumbLine();
    void paintCandidates();
    void paintPixelInHand();
    void paintPickedPixel();
    void paintSpan();
    void paintTick(double y, Sign sign);
    void paintBracket(std::int64_t row, Sign sign);
    void paintAxes();
    void paintSpanLabels();

    double px(double logical) const { return logical * m_style.scale; }
    QColor colour(Sign sign) const { return signColour(sign, m_style.palette); }
    /// A line that is seen on every colour: over a wider one in the palette's base.
    void drawHaloed(const QLineF &line, const QColor &colour, double width);
    QFont fontOfSize(double logicalPixels) const;

    QPainter &m_painter;
    const PixelGridStyle &m_style;
    const PixelGridMapping &m_mapping;
    const PixelGridScene &m_scene;
};

} // namespace pixelplumb
