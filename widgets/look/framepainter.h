// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/clippedline.h"
#include "core/runs/tracedscene.h"
#include "widgets/look/signs.h"
#include "widgets/look/viewmapping.h"

#include <QRectF>

#include <optional>
#include <span>
#include <vector>

class QPainter;

namespace pixelplumb {

/// Names of a primitive's vertices that are drawn: more would hide what they name.
inline constexpr std::size_t mostVertexNames = 12;

/// What an edge of a triangle is to the column scan.
enum class EdgeRole { Plain, Lower, Upper };

/// The roles of the edges 0–1, 1–2, 2–0 of the caller's triangle.
using EdgeRoles = std::array<EdgeRole, 3>;
EdgeRoles rolesOf(const SetUpRecord &setUp);

enum class HandleState { Idle, Hovered, Selected };

/// Whether y_B and y_T stand beside the ticks.
enum class EdgeNames { Hidden, Shown };

/// Where a note stands from its anchor.
enum class NoteSide { Right, Above, Below, AboveRight, BelowRight, AboveLeft, BelowLeft };

/// Draws what is known of a frame over its cells, on the screen or into a figure. Thin lines have a
/// casing of the opposite lightness, so that they can be read on every colour that a frame may
/// hold. Positions are in sample coordinates.
class FramePainter {
public:
    /// view: the part of the paint device that shows the frame; lines are clipped to it.
    FramePainter(QPainter &painter, const ViewMapping &mapping, const QPalette &palette,
                 const QRectF &view);

    void drawFrameEdge();
    /// Lines between the cells, for figures; blendGrid() does the same for the screen.
    void drawGrid();
    void drawOutline(const std::array<LatticePoint, 3> &corners, const EdgeRoles &roles);
    /// The curve that a shape stands for, a Bézier curve's control polygon, and how the corner of a
    /// circle's box belongs to it. Where it would be so dense that it hides the picture, the bounds
    /// of its vertices, dashed.
    void drawShapeOutline(const Shape &shape);
    /// The edges and the corners C₀, C₁, … of a polygon that clipping made, and between its corners
    /// those of the fan of triangles that is drawn.
    void drawClippedPolygon(const std::vector<LatticePoint> &corners);
    void drawRubberPath(const std::vector<LatticePoint> &points);
    /// A line to a vertex that is not placed yet.
    void drawRubberLine(const LatticePoint &from, const LatticePoint &to);
    void drawHandle(const LatticePoint &point, const Colour &colour, HandleState state);
    /// A vertex that a click would place.
    void drawCandidate(const LatticePoint &point, const Colour &colour);
    /// P0, P1 or P2 beside a vertex, on the side that is turned away from `inside`, or as near to
    /// it as no other name stands.
    void drawVertexName(const QString &name, const LatticePoint &point, const QPointF &inside);
    /// Through all samples of a column or a row.
    void drawPlumbLine(const SpanPlace &place);
    /// y_B and y_T where they meet the plumb line.
    void drawEdgeTicks(const SpanRecord &span, EdgeNames names = EdgeNames::Shown);
    /// The point of the rule off-screen-point; out of view, an arrow towards it at the border.
    void drawOffScreenPoint(const LatticePoint &point);
    void drawPickedPixel(const QPoint &pixel);
    void drawPixelBreakpoint(const QPoint &pixel);
    void drawNote(const QString &text, const QPointF &anchor, NoteSide side);
    /// Below the pointer and to its right, or in the first of its other quarters where it covers
    /// no note and none of those places; where all cover a note, beside that.
    void drawPointerNote(const QString &text, const QPointF &pointer,
                         std::span<const QRectF> places);
    /// In a corner of the view or between two, in long lines or in short ones, where it covers no
    /// handle, least of what else has a place, those places included, and least of the frame; of
    /// equal ones the first from the lower left.
    void drawCornerNote(const QString &text, std::span<const QRectF> places = {});
    /// Between two positions.
    void drawCased(const QLineF &line, const QColor &colour, double width,
                   Qt::PenStyle style = Qt::SolidLine);

    /// Where handles, names and notes stand so far.
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
    bool isFree(const QRectF &plate) const; ///< of all that has a place
    QRectF drawPlate(const QSizeF &text, const QPointF &anchor, NoteSide side);
    QRectF drawPlateIn(const QRectF &plate); ///< returns where its text stands
    bool isNearView(const QPointF &position) const;

    QPainter &m_painter;
    const ViewMapping &m_mapping;
    const QPalette &m_palette;
    QRectF m_view;
    std::vector<QRectF> m_plates;
    std::vector<QRectF> m_handles, m_notes; ///< those among them, but for the pointer's note
};

/// The colour of the lines between cells; they fade in as the cells grow, and are transparent where
/// cells are too small for them.
QColor gridColour(const ViewMapping &mapping);

/// The smallest cell that has room for a difference's glyph, in logical pixels.
inline constexpr double leastGlyphCell = 9;

/// Marks a cell: the sign's glyph where it has room, else a frame, else the colour alone.
void paintMark(QPainter &painter, const QRectF &cell, Sign sign, const QPalette &palette);
/// The same of a difference from the truth; nothing where there is none.
void paintDifference(QPainter &painter, const QRectF &cell, Difference kind,
                     const QPalette &palette);

} // namespace pixelplumb
