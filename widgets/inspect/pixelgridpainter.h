// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/inspect/pixelgridscene.h"
#include "widgets/look/cellvalues.h"

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
    ByteNotation notation = ByteNotation::Decimal;

    CellValueStyle values() const { return {font, scale, notation}; }
};

/// Whether room for y_B and y_T is kept beside the cells; without a current column or row the cells
/// take it.
enum class BoundsRoom { None, Kept };

/// The room that axis labels and the names of y_B and y_T need around the cells.
QMargins pixelGridMargins(const PixelGridStyle &style, const QSize &area, int largestRowDigits,
                          BoundsRoom bounds);

/// Draws a PixelGridScene with a painter that works in device pixels. FramePainter draws what the
/// canvas shows too; this class adds the values and signs for which only large cells have room.
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
    void paintCandidates();
    void paintCurrentPixel();
    void paintSpan(FramePainter &frame);
    void paintBracket(FramePainter &frame, std::int64_t along, Sign sign);
    void paintAxes();
    void paintSpanLabels();

    double px(double logical) const { return logical * m_style.scale; }
    QColor colour(Sign sign) const { return signColour(sign, m_style.palette); }
    /// Calls draw(frame), whose positions are logical pixels.
    template <class Draw>
    void drawFrame(const Draw &draw);
    QFont fontOfSize(double logicalPixels) const;

    QPainter &m_painter;
    const PixelGridStyle &m_style;
    const PixelGridMapping &m_mapping;
    ViewMapping m_view; ///< m_mapping in logical pixels
    const PixelGridScene &m_scene;
};

} // namespace pixelplumb
