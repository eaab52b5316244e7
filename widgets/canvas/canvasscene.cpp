// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasscene.h"

#include "core/geometry/shapeediting.h"
#include "widgets/canvas/canvasoutlines.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/corewords.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/numberformat.h"
#include "widgets/model/effectswitches.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenetracer.h"
#include "widgets/model/steptext.h"
#include "widgets/model/studentpicture.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

/// Collects the shown items, piece by piece.
class Collector {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::Canvas)

public:
    Collector(const CanvasSources &sources, const CanvasView &view, const CanvasHand &hand,
              CanvasScene &scene)
        : m_document(*sources.document)
        , m_playhead(*sources.playhead)
        , m_options(*sources.options)
        , m_previewer(sources.previewer)
        , m_effects(sources.effects)
        , m_judgement(markedJudgement(sources))
        , m_judged(judgedFrame(sources, hand))
        , m_view(view)
        , m_hand(hand)
        , m_isTruth(isTruthVisible(sources, hand))
        , m_scene(scene)
    {
    }

    void addPicture()
    {
        const ScenePicture *preview = shownPreview();
        const TracedScene *traced = tracedOfFrame(m_document, m_playhead);
        m_scene.position = m_playhead.position();
        if (m_judged)
            m_scene.frame = m_judged;
        else if (m_isTruth && preview && preview->exactTwin())
            m_scene.frame = preview->exactTwin();
        else if (m_isTruth)
            m_scene.frame = traced ? &traced->truth : nullptr;
        else if (preview)
            m_scene.frame = &preview->drawn();
        else
            m_scene.frame = traced ? m_playhead.frame() : nullptr;
        if (m_options.isGridShown())
            m_scene.grid = CanvasScene::Grid::Shown;
        m_scene.notation = m_options.notation();
        if (!m_options.areDifferencesShown() || m_isTruth || (m_judged && m_hand.isPeeking))
            return;
        if (m_judgement && m_judgement->frame == m_view.mapping().frame()) {
            // Missing or extra pixels ahead of the current step would reveal the answer.
            const auto paced = m_playhead.isAheadHidden() ? m_playhead.sharedTraced() : nullptr;
            m_scene.marked = CanvasDifferences::Source{.traced = paced, .judgement = m_judgement};
            return;
        }
        m_scene.marked = preview ? CanvasDifferences::Source{nullptr, m_previewer->picture()}
                                 : CanvasDifferences::Source{m_playhead.sharedTraced(), nullptr};
        if (m_effects)
            m_scene.marked->changes = m_effects->changes();
    }

    void addSigns()
    {
        for (const auto &[x, y] : m_playhead.breakpoints().pixels)
            m_scene.breakpoints.emplace_back(x, y);
        m_scene.picked = m_playhead.pickedPixel();
        const std::optional<std::size_t> span = m_playhead.currentSpan();
        if (const std::optional<LatticePoint> point = m_document.offScreenPoint())
            m_scene.offScreenPoint = m_view.onSamples(*point);
        if (span && tracedOfFrame(m_document, m_playhead))
            m_scene.span = m_playhead.traced()->trace->span(*span);
    }

    void addRulerMarks()
    {
        for (const std::int64_t x : m_playhead.breakpoints().columns)
            m_scene.columnMarks.push_back({double(x), Sign::Breakpoint});
        if (const std::optional<QPoint> pixel = m_playhead.pickedPixel()) {
            m_scene.columnMarks.push_back({double(pixel->x()), Sign::PickedPixel});
            m_scene.rowMarks.push_back({double(pixel->y()), Sign::PickedPixel});
        }
        for (const std::int64_t y : m_playhead.breakpoints().rows)
            m_scene.rowMarks.push_back({double(y), Sign::Breakpoint});
        const std::optional<SpanPlace> place = m_playhead.currentPlace();
        if (place && place->axis == SpanAxis::Column)
            m_scene.columnMarks.push_back({double(place->coordinate), Sign::CurrentColumn});
        if (place && place->axis == SpanAxis::Row)
            m_scene.rowMarks.push_back({double(place->coordinate), Sign::CurrentColumn});
    }

    /// Over a pending vertex the pointer places none: the vertices stay visible.
    void addCandidate()
    {
        std::vector<Vertex> vertices;
        for (const Vertex &vertex : m_document.pendingVertices()) {
            const LatticePoint place = m_document.atCurrentFrame(vertex.position);
            vertices.push_back({m_view.onSamples(place), vertex.colour});
            m_scene.pending.push_back({vertices.back().position, vertex.colour, HandleState::Idle});
        }
        if (!m_hand.candidate) {
            for (const Vertex &vertex : vertices)
                m_scene.rubberPath.push_back(vertex.position);
            return;
        }
        const LatticePoint tip = m_view.onSamples(*m_hand.candidate);
        const Colour colour = m_document.nextColour();
        m_scene.candidate = {tip, colour};
        if (!vertices.empty()) {
            vertices.push_back({tip, colour});
            addRubber(vertices);
        }
        // The readout, if shown, has the coordinates.
        if (m_hand.readout.isEmpty() && (!m_document.pendingVertices().empty() || m_hand.isPressed))
            m_scene.notes.push_back({coordinateNote(*m_hand.candidate),
                                     m_view.mapping().positionOf(tip), NoteSide::BelowRight});
    }

    void addNotes(const OutlineChoice &choice)
    {
        const std::optional<VertexRef> ref = m_document.selectedVertex();
        if (ref && m_hand.isMoving) {
            const LatticePoint point
                = m_document.atCurrentFrame(m_document.vertexAt(*ref)->position);
            m_scene.notes.push_back(
                {coordinateNote(point), m_view.positionOf(point), NoteSide::BelowRight});
        }
        if (m_hand.pointer && !m_hand.readout.isEmpty())
            m_scene.readout = {m_hand.readout, *m_hand.pointer};
        const QRectF area = m_view.area();
        if (const QString text = hint(); !text.isEmpty())
            m_scene.notes.push_back({text, {area.center().x(), area.top()}, NoteSide::Below});
        if (const QString text = viewNote(choice); !text.isEmpty())
            m_scene.notes.push_back({text, {area.center().x(), area.bottom()}, NoteSide::Above});
    }

private:
    /// The picture in place of the run: until the present scene's run is there, and at the end of a
    /// cut run.
    const ScenePicture *shownPreview() const
    {
        const ScenePicture *picture = m_previewer ? m_previewer->picture().get() : nullptr;
        if (!picture || picture->spec() != m_view.mapping().frame())
            return nullptr;
        const bool isAtEnd = m_playhead.position() == m_playhead.end();
        return m_previewer->isAheadOfTrace() || isAtEnd ? picture : nullptr;
    }

    /// Adds what the pending vertices and the tip, the last of them, would make.
    void addRubber(const std::vector<Vertex> &vertices)
    {
        const PrimitiveKind kind = m_document.placedKind();
        const bool closes = kind == PrimitiveKind::Triangle || kind == PrimitiveKind::Polygon;
        if (!closes && placedVertexCount(kind) == vertices.size()) {
            m_scene.rubberShape = shapeFrom(kind, vertices, {});
            return;
        }
        for (const Vertex &vertex : vertices)
            m_scene.rubberPath.push_back(vertex.position);
        if (closes && vertices.size() > 2)
            m_scene.rubberPath.push_back(vertices.front().position);
    }

    QString hint() const
    {
        const TracedScene *traced = m_playhead.traced();
        const bool isAhead = m_previewer && m_previewer->isAheadOfTrace();
        if (traced && !isAhead && traced->scene.method != m_document.scene().method)
            return tr("Still the picture of %1").arg(methodTitle(*traced->method));
        if (m_judged)
            return m_hand.isPeeking
                ? tr("Expected picture")
                : tr("The student's picture (S); hold Shift for the expected one");
        if (m_isTruth)
            return tr("Truth: the exact picture");
        if (m_playhead.isAheadHidden() && (m_options.isTruthShown() || m_hand.isPeeking))
            return tr("The truth is hidden while Predict asks");
        const QString foreign = m_document.pendingVertices().empty()
            ? foreignSceneHint(m_document.scene())
            : QString();
        if (!foreign.isEmpty() && !m_hand.isDrawing)
            return foreign;
        if (!foreign.isEmpty())
            return foreign + u'\n' + placingHint(m_document.placedKind(), 0, FrameContent::Empty);
        if (!m_hand.isDrawing)
            return {};
        return placingHint(m_document.placedKind(), m_document.pendingVertices().size(),
                           m_document.scene().isEmpty() ? FrameContent::Empty
                                                        : FrameContent::Drawn);
    }

    /// Why the view differs from the usual one.
    QString viewNote(const OutlineChoice &choice) const
    {
        QStringList notes;
        if (const QString frame = frameText(m_document); m_document.currentFrame() > 0)
            notes += frame.left(1).toUpper() + frame.sliced(1);
        if (m_scene.marked && m_judgement && !m_judged)
            notes += tr("Marked: the student's picture");
        if (shownPreview() && !m_isTruth && !m_previewer->isAheadOfTrace())
            notes += tr("Finished picture; the first %L1 steps are recorded").arg(m_playhead.end());
        if (choice.isCrowded())
            notes += tr("More than %1 in view: outlines and handles show only under the pointer "
                        "and for the current triangle")
                         .arg(OutlineChoice::mostInView);
        return notes.join(u" · "_s);
    }

    const SceneDocument &m_document;
    const Playhead &m_playhead;
    const DisplayOptions &m_options;
    const ScenePreviewer *m_previewer;
    const EffectSwitches *m_effects;
    std::shared_ptr<const PictureJudgement> m_judgement;
    const FrameBuffer *m_judged;
    const CanvasView &m_view;
    const CanvasHand &m_hand;
    bool m_isTruth;
    CanvasScene &m_scene;
};

} // namespace

std::shared_ptr<const PictureJudgement> markedJudgement(const CanvasSources &sources)
{
    const auto judgement = sources.student ? sources.student->judgement() : nullptr;
    return judgement && judgement->frame == sources.document->scene().frame ? judgement : nullptr;
}

QString coordinateNote(const LatticePoint &point)
{
    return u"(%1, %2)"_s.arg(displayText(Quantity::rational(point.x, unitsPerPixel)),
                             displayText(Quantity::rational(point.y, unitsPerPixel)));
}

const FrameBuffer *judgedFrame(const CanvasSources &sources, const CanvasHand &hand)
{
    const bool isShown = sources.options->isStudentShown() && !sources.options->isTruthShown()
        && !sources.playhead->isAheadHidden() && markedJudgement(sources);
    if (!isShown)
        return nullptr;
    const JudgedFrames &frames = sources.student->frames();
    return hand.isPeeking ? &frames.expected() : &frames.found();
}

bool isTruthVisible(const CanvasSources &sources, const CanvasHand &hand)
{
    if (judgedFrame(sources, hand))
        return false;
    return (sources.options->isTruthShown() || hand.isPeeking)
        && !sources.playhead->isAheadHidden();
}

CanvasScene canvasScene(const CanvasSources &sources, const CanvasView &view,
                        const OutlineChoice &choice, const CanvasHand &hand)
{
    CanvasScene scene;
    Collector collector(sources, view, hand, scene);
    collector.addPicture();
    collector.addSigns();
    collector.addRulerMarks();
    addOutlines(scene, sources, view, choice, hand);
    addImageHandles(scene, sources, view, hand);
    collector.addCandidate();
    collector.addNotes(choice);
    return scene;
}

} // namespace pixelplumb
