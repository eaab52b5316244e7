// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/clippedline.h"
#include "core/layers/layerpainter.h"
#include "core/runs/tracedscene.h"
#include "widgets/look/signs.h"
#include "widgets/look/viewmapping.h"

#include <QtWidgets>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// Where layers are painted over a frame in a view.
LayerSurface layerSurface(const ViewMapping &mapping, const QRectF &view, const QPalette &palette);

/// A pixel's side, logical px.
double cellSideOf(const ViewMapping &mapping);

/// How many of a primitive's vertex names are drawn at most: more would hide the vertices.
inline constexpr std::size_t mostVertexNames = 12;

/// The role of a triangle's edge in the column scan.
enum class EdgeRole { Plain, Lower, Upper };

/// The roles of the edges 0–1, 1–2, 2–0 of the caller's triangle.
using EdgeRoles = std::array<EdgeRole, 3>;
EdgeRoles rolesOf(const SetUpRecord &setUp);

enum class HandleState { Idle, Hovered, Selected };

/// Whether the ticks are labelled y_B and y_T.
enum class EdgeNames { Hidden, Shown };

/// The position of a note relative to its anchor.
enum class NoteSide { Right, Above, Below, AboveRight, BelowRight, AboveLeft, BelowLeft };

/// Draws annotations over a frame's cells, on the screen or into a figure. Thin lines have a casing
/// of the opposite lightness, so that they are visible on every colour. Positions are in sample
/// coordinates.
class FramePainter {
public:
    /// view: the part of the paint device that shows the frame; lines are clipped to it.
    FramePainter(QPainter &painter, const ViewMapping &mapping, const QPalette &palette,
                 const QRectF &view);

    void drawFrameEdge();
    /// Draws the lines between cells, for figures; blendGrid() does it for the screen.
    void drawGrid();
    void drawOutline(const std::array<LatticePoint, 3> &corners, const EdgeRoles &roles);
    /// Draws the curve of a shape, a Bézier curve's control polygon, and the link from a circle to
    /// the corner of its box. Where all that would be so dense that it hides the picture, only the
    /// dashed bounds of its vertices.
    void drawShapeOutline(const Shape &shape);
    /// Draws the edges and the corners C₀, C₁, … of a clipped polygon, and between its corners the
    /// edges of the fan of triangles that is drawn.
    void drawClippedPolygon(const std::vector<LatticePoint> &corners);
    void drawRubberPath(const std::vector<LatticePoint> &points);
    /// Draws a line to a vertex that is not placed yet.
    void drawRubberLine(const LatticePoint &from, const LatticePoint &to);
    void drawHandle(const LatticePoint &point, const Colour &colour, HandleState state);
    /// Draws a vertex that a click would place.
    void drawCandidate(const LatticePoint &point, const Colour &colour);
    /// Draws P0, P1 or P2 beside a vertex, on the side away from `inside`, or as near to that as
    /// other names allow.
    void drawVertexName(const QString &name, const LatticePoint &point, const QPointF &inside);
    /// Draws a line through all samples of a column or a row.
    void drawPlumbLine(const SpanPlace &place);
    /// Draws ticks for y_B and y_T where they meet the plumb line.
    void drawEdgeTicks(const SpanRecord &span, EdgeNames names = EdgeNames::Shown);
    /// Draws the point of the rule off-screen-point; where it is out of view, an arrow towards it
    /// at the border.
    void drawOffScreenPoint(const LatticePoint &point);
    void drawPickedPixel(const QPoint &pixel);
    void drawPixelBreakpoint(const QPoint &pixel);
    void drawNote(const QString &text, const QPointF &anchor, NoteSide side);
    /// Draws a note below and right of the pointer, or in the first of its other quarters where it
    /// covers no note and none of `places`; where each covers a note, next to that note.
    void drawPointerNote(const QString &text, const QPointF &pointer,
                         std::span<const QRectF> places);
    /// Draws a note in a corner of the view or between two corners, in long or short lines. It goes
    /// where it covers least of the handles, then of other notes, names and `places`, then of the
    /// frame; among equals, the first from the lower left.
    void drawCornerNote(const QString &text, std::span<const QRectF> places = {});
    /// Draws a line with a casing between two positions.
    void drawCased(const QLineF &line, const QColor &colour, double width,
                   Qt::PenStyle style = Qt::SolidLine);

    /// The rectangles of the handles, names and notes drawn so far.
    const std::vector<QRectF> &plates() const { return m_plates; }

private:
    static constexpr double handleRadius = 5; ///< logical pixels

    void drawOutlineLines(const std::vector<QLineF> &lines, double length);
    void drawBounds(const std::vector<QPointF> &points); ///< at least one
    QColor casing() const;
    void fillDevice(const QRect &device, const QColor &colour);
    /// A bound's symbol with its subscript: y_B, x_L.
    struct EdgeName {
        const char *symbol;
        const char *subscript;
    };
    void drawEdgeTick(const QPointF &at, Sign sign, Qt::Orientation along);
    void drawEdgeName(const QPointF &at, const EdgeName &name, Sign sign, NoteSide side);
    double widestNote() const;
    QSizeF noteSize(const QString &text, double widest) const;
    void drawNoteIn(const QRectF &plate, const QString &text);
    QRectF plateAt(const QSizeF &text, const QPointF &anchor, NoteSide side) const;
    bool isFree(const QRectF &plate) const; ///< of all drawn plates
    QRectF drawPlate(const QSizeF &text, const QPointF &anchor, NoteSide side);
    QRectF drawPlateIn(const QRectF &plate); ///< returns the rectangle of its text
    bool isNearView(const QPointF &position) const;

    QPainter &m_painter;
    const ViewMapping &m_mapping;
    const QPalette &m_palette;
    QRectF m_view;
    std::vector<QRectF> m_plates;
    std::vector<QRectF> m_handles, m_notes; ///< parts of m_plates, without the pointer's note
};

/// The colour of the lines between cells; they fade in as the cells grow, and are transparent where
/// cells are too small.
QColor gridColour(const ViewMapping &mapping);

/// The smallest cell with room for a difference's glyph, in logical pixels.
inline constexpr double leastGlyphCell = 9;

/// Writes numbers into the cells where these have room: `numberAt(pixel)`, in the widget's font.
void drawCellNumbers(QPainter &painter, const ViewMapping &mapping, const QRectF &view,
                     const QWidget &widget,
                     const std::function<std::optional<int>(const QPoint &)> &numberAt);

/// Marks a cell: by the sign's glyph where it has room, else by a frame, else by the colour alone.
void paintMark(QPainter &painter, const QRectF &cell, Sign sign, const QPalette &palette);
/// Marks a difference from the truth as paintMark() does; nothing where there is none.
void paintDifference(QPainter &painter, const QRectF &cell, Difference kind,
                     const QPalette &palette);

} // namespace pixelplumb
