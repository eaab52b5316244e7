// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/inspect/pixelgridscene.h"
#include "widgets/look/cellvalues.h"

#include <QtGui>

namespace pixelplumb {

enum class GridLines { Hidden, Shown };

/// How the pixel grid is drawn.
struct PixelGridStyle {
    QPalette palette;
    QFont font;
    GridLines lines = GridLines::Shown;
    ByteNotation notation = ByteNotation::Decimal;

    CellValueStyle values() const { return {font, notation}; }
};

/// Whether room for y_B and y_T is kept beside the cells; without a current column or row the cells
/// take it.
enum class BoundsRoom { None, Kept };

/// The room that axis labels and the names of y_B and y_T need around the cells.
QMargins pixelGridMargins(const PixelGridStyle &style, const QSize &area, int largestRowDigits,
                          BoundsRoom bounds);

/// Draws a PixelGridScene. FramePainter draws what the canvas shows too; this class adds the values
/// and signs for which only large cells have room.
class PixelGridPainter {
public:
    PixelGridPainter(QPainter &painter, const PixelGridStyle &style, const ViewMapping &mapping,
                     const PixelGridScene &scene);

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

    QColor colour(Sign sign) const { return signColour(sign, m_style.palette); }
    double cellSize() const { return m_grid.height() / m_mapping.frame().height; }
    bool hasCell(const QPoint &pixel) const;

    QPainter &m_painter;
    const PixelGridStyle &m_style;
    const ViewMapping &m_mapping;
    QRectF m_grid; ///< all cells
    const PixelGridScene &m_scene;
};

} // namespace pixelplumb
