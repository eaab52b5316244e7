// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerdrawing.h"
#include "widgets/canvas/canvasdifferences.h"
#include "widgets/canvas/outlinechoice.h"
#include "widgets/canvas/ruler.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/framepainter.h"

namespace pixelplumb {

class CanvasView;
class EffectSwitches;
class Playhead;
class ScenePreviewer;
class StudentPicture;

/// The objects from which everything on the canvas comes.
struct CanvasSources {
    SceneDocument *document = nullptr;
    Playhead *playhead = nullptr;
    DisplayOptions *options = nullptr;
    const ScenePreviewer *previewer = nullptr; ///< null: only runs are shown
    const EffectSwitches *effects = nullptr; ///< null: nothing is forced
    const StudentPicture *student = nullptr; ///< null: no student's picture
};

/// What the pointer and the keys are doing.
struct CanvasHand {
    std::optional<VertexRef> hovered;
    std::optional<std::size_t> hoveredCorner; ///< of the affine map's image
    std::optional<std::size_t> chosenCorner;
    /// The vertex that a click or Enter would place now, in the scene's coordinates.
    std::optional<LatticePoint> candidate;
    bool isPressed = false; ///< a mouse button is doing something
    bool isMoving = false; ///< a vertex
    bool isPeeking = false; ///< at the truth, or at what is expected of a student
    bool isDrawing = true; ///< a left click places vertices
    /// Where the pointer is, if visible and with no button held; and the text beside it.
    std::optional<QPointF> pointer;
    QString readout;
};

/// What the canvas shows, taken once from the document, the run and the hand, so that painting only
/// draws. Points are sample coordinates, anchors positions on the widget.
struct CanvasScene {
    struct Outline {
        std::array<LatticePoint, 3> corners;
        EdgeRoles roles;
    };
    struct Handle {
        LatticePoint point;
        Colour colour;
        HandleState state = HandleState::Idle;
    };
    struct VertexName {
        QString name;
        LatticePoint point;
        QPointF inside; ///< of the primitive
    };
    struct Candidate {
        LatticePoint point;
        Colour colour;
    };
    struct Note {
        QString text;
        QPointF anchor;
        NoteSide side = NoteSide::Below;
    };
    enum class Grid { Hidden, Shown };

    const FrameBuffer *frame = nullptr; ///< whose cells are shown; null: only the background
    Grid grid = Grid::Hidden;
    ByteNotation notation = ByteNotation::Decimal; ///< of the values in cells that have room
    std::optional<CanvasDifferences::Source> marked; ///< none: differences are not shown
    std::size_t position = 0; ///< of the playhead

    std::vector<Outline> outlines;
    std::vector<Shape> shapes; ///< outlined over the triangles
    /// What clipping makes of the current triangle's face; empty: not shown.
    std::vector<LatticePoint> clippedPolygon;
    LayerDrawing layers; ///< that are switched on
    std::vector<QPoint> breakpoints;
    std::optional<QPoint> picked;
    std::optional<SpanRecord> span; ///< the current span
    std::optional<LatticePoint> offScreenPoint; ///< of the rule in force
    std::vector<Handle> handles;
    std::vector<VertexName> names;
    /// The outline that the pending vertices and the candidate would make, and these vertices over
    /// it.
    std::vector<LatticePoint> rubberPath;
    std::optional<Shape> rubberShape;
    std::vector<Handle> pending;
    std::optional<Candidate> candidate;
    std::vector<Note> notes;
    struct Readout {
        QString text;
        QPointF pointer;
    };
    std::optional<Readout> readout; ///< beside the pointer

    std::vector<RulerMark> columnMarks;
    std::vector<RulerMark> rowMarks;
};

/// `choice` knows which outlines are visible.
CanvasScene canvasScene(const CanvasSources &sources, const CanvasView &view,
                        const OutlineChoice &choice, const CanvasHand &hand);

/// The verdict on the student's picture, where that is what is marked; null otherwise.
std::shared_ptr<const PictureJudgement> markedJudgement(const CanvasSources &sources);

/// "(27 1/2, 19)"
QString coordinateNote(const LatticePoint &point);

/// The student's picture or, while peeking, the one expected of the student, where one of them is
/// shown instead of the frame; null otherwise.
const FrameBuffer *judgedFrame(const CanvasSources &sources, const CanvasHand &hand);

/// Whether the truth is shown instead of the frame.
bool isTruthVisible(const CanvasSources &sources, const CanvasHand &hand);

} // namespace pixelplumb
