// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasoutlines.h"

#include "core/scene/sceneprojection.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double bareHitRadius = 3; ///< of a vertex without a handle among many others

/// A triangle as drawn: a moving scene at its current frame.
Triangle drawnTriangle(const SceneDocument &document, std::size_t index)
{
    Triangle triangle = document.scene().triangles[index];
    for (Vertex &vertex : triangle.vertices)
        vertex.position = document.atCurrentFrame(vertex.position);
    return triangle;
}

std::array<LatticePoint, 3> cornersOf(const Triangle &triangle, const CanvasView &view)
{
    std::array<LatticePoint, 3> corners;
    std::ranges::transform(triangle.vertices, corners.begin(), [&view](const Vertex &vertex) {
        return view.onSamples(vertex.position);
    });
    return corners;
}

/// The vertex nearest to a position so far.
struct NearestVertex {
    std::optional<VertexRef> ref;
    double distance = handleHitRadius;

    void offer(const VertexRef &vertex, const QPointF &way, double reach)
    {
        const double length = std::hypot(way.x(), way.y());
        if (length > std::min(distance, reach))
            return;
        ref = vertex;
        distance = length;
    }
};

/// The document's primitive that the current step draws; none for a solid's triangle.
std::optional<int> steppedPrimitive(const CanvasSources &sources)
{
    const std::optional<TraceStep> step = sources.playhead->currentStep();
    const auto index = step ? sources.playhead->traced()->indexInScene(step->primitive)
                            : std::optional<std::size_t>();
    const bool isThere = index && std::int64_t(*index) < sources.document->primitiveCount();
    return isThere ? std::optional(int(*index)) : std::nullopt;
}

OutlineChoice::Current currentPrimitives(const CanvasSources &sources,
                                         const std::optional<VertexRef> &hovered)
{
    return {sources.document->selectedVertex(), hovered, steppedPrimitive(sources)};
}

std::optional<SetUpRecord> setUpOf(int triangle, const CanvasSources &sources)
{
    const TracedScene *traced = tracedOfFrame(*sources.document, *sources.playhead);
    const auto index = std::size_t(triangle);
    // A drag may be ahead of the trace: numbers of the earlier triangle are not shown.
    if (!traced || index >= traced->trace->primitiveCount()
        || index >= traced->scene.triangles.size()
        || traced->scene.triangles[index] != drawnTriangle(*sources.document, index))
        return std::nullopt;
    return traced->trace->setUp(index);
}

/// The primitive whose vertices are named: the selected vertex's, else the current step's.
std::optional<int> namedPrimitive(const CanvasSources &sources)
{
    if (const std::optional<VertexRef> ref = sources.document->selectedVertex();
        ref && ref->primitive != VertexRef::pending)
        return ref->primitive;
    const bool isAlone
        = sources.document->primitiveCount() == 1 && sources.document->scene().solids.empty();
    return isAlone ? std::optional(0) : steppedPrimitive(sources);
}

/// Outlines the solid's triangle that the current step draws; it has no handles.
void addSolidsTriangle(CanvasScene &scene, const CanvasSources &sources)
{
    const TracedScene *traced = tracedOfFrame(*sources.document, *sources.playhead);
    const std::optional<TraceStep> step = sources.playhead->currentStep();
    if (!traced || !step || !traced->primitives.isTriangle(step->primitive)
        || traced->indexInScene(step->primitive))
        return;
    const auto &[a, b, c] = traced->primitives.triangles[step->primitive].vertices;
    scene.outlines.push_back(
        {{a.position, b.position, c.position}, rolesOf(traced->trace->setUp(step->primitive))});
    const TriangleSource *source = traced->primitives.sourceOf(step->primitive);
    if (source && sources.options->isClippingShown())
        scene.clippedPolygon = clippedPolygon(traced->scene, *source);
}

void addOutline(CanvasScene &scene, int primitive, const CanvasSources &sources,
                const CanvasView &view)
{
    const Scene &drawn = sources.document->scene();
    const auto index = std::size_t(primitive);
    if (index >= drawn.triangles.size()) {
        Shape &shape = scene.shapes.emplace_back(drawn.shapes[index - drawn.triangles.size()]);
        for (Vertex &vertex : shape.vertices)
            vertex.position = view.onSamples(sources.document->atCurrentFrame(vertex.position));
        return;
    }
    const bool isCurrent = steppedPrimitive(sources) == primitive;
    const std::optional<SetUpRecord> setUp = isCurrent ? setUpOf(primitive, sources) : std::nullopt;
    scene.outlines.push_back({cornersOf(drawnTriangle(*sources.document, index), view),
                              setUp ? rolesOf(*setUp) : EdgeRoles{}});
}

/// A vertex's name, with the file's number where that differs from the method's.
QString vertexName(std::size_t rank, std::size_t inFile)
{
    const QString name = u"P%1"_s.arg(rank);
    return rank == inFile ? name
                          : QCoreApplication::translate("pixelplumb::Canvas", "%1 (vertex %2)")
                                .arg(name, QString::number(inFile));
}

/// The vertices of a circle or an ellipse, neither of which is on the curve.
QString roundName(std::size_t vertex)
{
    return vertex == 0
        ? QCoreApplication::translate("pixelplumb::Canvas", "P0 (centre)")
        : QCoreApplication::translate("pixelplumb::Canvas", "P1 (corner of its box)");
}

/// Names the vertices P0, P1, P2: a triangle's in the method's sorted order, a shape's in file
/// order.
void addNames(CanvasScene &scene, int primitive, const CanvasSources &sources,
              const CanvasView &view)
{
    const SceneDocument &document = *sources.document;
    std::vector<Vertex> vertices = document.verticesOf(primitive);
    for (Vertex &vertex : vertices)
        vertex.position = document.atCurrentFrame(vertex.position);
    std::vector<std::size_t> order(vertices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (document.kindOf(primitive) == PrimitiveKind::Triangle) {
        const std::optional<SetUpRecord> setUp = setUpOf(primitive, sources);
        const std::array<int, 3> sorted = setUp
            ? setUp->order
            : sortedByColumn(document.scene().triangles[std::size_t(primitive)]);
        std::ranges::copy(sorted, order.begin());
    }
    QPointF inside;
    for (const Vertex &vertex : vertices)
        inside += view.positionOf(vertex.position) / double(vertices.size());
    const PrimitiveKind kind = document.kindOf(primitive);
    const bool isRound = kind == PrimitiveKind::Circle || kind == PrimitiveKind::Ellipse;
    for (std::size_t rank = 0; rank < std::min(order.size(), mostVertexNames); ++rank)
        scene.names.push_back({isRound ? roundName(rank) : vertexName(rank, order[rank]),
                               view.onSamples(vertices[order[rank]].position), inside});
}

/// Whether the vertices layer already names them, with their coordinates.
bool isNamedByLayer(int primitive, const CanvasSources &sources)
{
    return sources.options->layers().contains(u"vertices"_s)
        && primitive == steppedPrimitive(sources).value_or(primitive);
}

} // namespace

void addOutlines(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view,
                 const OutlineChoice &choice, const CanvasHand &hand)
{
    const SceneDocument &document = *sources.document;
    const auto addHandle = [&](const VertexRef &ref, const Vertex &vertex) {
        HandleState state = HandleState::Idle;
        if (ref == document.selectedVertex())
            state = HandleState::Selected;
        else if (ref == hand.hovered)
            state = HandleState::Hovered;
        scene.handles.push_back(
            {view.onSamples(document.atCurrentFrame(vertex.position)), vertex.colour, state});
    };
    for (const int primitive : choice.primitives(currentPrimitives(sources, hand.hovered))) {
        addOutline(scene, primitive, sources, view);
        if (!choice.hasHandles(primitive)) {
            std::vector<std::optional<VertexRef>> current = {document.selectedVertex()};
            if (hand.hovered != current.front())
                current.push_back(hand.hovered);
            for (const std::optional<VertexRef> &ref : current) {
                const auto vertex
                    = ref && ref->primitive == primitive ? document.vertexAt(*ref) : std::nullopt;
                if (vertex)
                    addHandle(*ref, *vertex);
            }
            continue;
        }
        const std::vector<Vertex> vertices = document.verticesOf(primitive);
        for (std::size_t i = 0; i < vertices.size(); ++i)
            addHandle({primitive, int(i)}, vertices[i]);
    }
    addSolidsTriangle(scene, sources);
    const std::vector<Vertex> &pending = document.pendingVertices();
    for (std::size_t i = 0; i < pending.size(); ++i)
        addHandle({VertexRef::pending, int(i)}, pending[i]);
    if (const std::optional<int> named = namedPrimitive(sources);
        named && choice.hasHandles(*named) && !isNamedByLayer(*named, sources))
        addNames(scene, *named, sources, view);
}

std::optional<VertexRef> vertexAt(const QPointF &position, const CanvasSources &sources,
                                  const CanvasView &view, const OutlineChoice &choice)
{
    if (!view.area().contains(position))
        return std::nullopt;
    const OutlineChoice::Current current = currentPrimitives(sources, std::nullopt);
    const QPointF reach(handleHitRadius, handleHitRadius);
    const SceneBox box = sceneBoxOf(QRectF(position - reach, position + reach), view.mapping());
    NearestVertex nearest;
    const auto offer = [&](int primitive, std::span<const Vertex> vertices) {
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const LatticePoint place = sources.document->atCurrentFrame(vertices[i].position);
            if (!box.contains(place))
                continue;
            const VertexRef ref{primitive, int(i)};
            const bool hasHandle = ref == current.selected
                || (choice.hasHandles(primitive)
                    && (!choice.isCrowded() || current.holds(primitive)));
            nearest.offer(ref, view.positionOf(place) - position,
                          hasHandle ? handleHitRadius : bareHitRadius);
        }
    };
    int primitive = 0;
    for (const Triangle &triangle : sources.document->scene().triangles)
        offer(primitive++, triangle.vertices);
    for (const Shape &shape : sources.document->scene().shapes)
        offer(primitive++, shape.vertices);
    offer(VertexRef::pending, sources.document->pendingVertices());
    return nearest.ref;
}

bool isOffScreenPointAt(const QPointF &position, const SceneDocument &document,
                        const CanvasView &view)
{
    const std::optional<LatticePoint> point = document.offScreenPoint();
    if (!point || !view.area().contains(position))
        return false;
    const QPointF way = view.positionOf(*point) - position;
    return std::hypot(way.x(), way.y()) <= handleHitRadius;
}

const TracedScene *tracedOfFrame(const SceneDocument &document, const Playhead &playhead)
{
    const TracedScene *traced = playhead.traced();
    return traced && traced->scene.frame == document.scene().frame ? traced : nullptr;
}

} // namespace pixelplumb
