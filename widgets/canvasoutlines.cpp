// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas.h"
#include "widgets/framepainter.h"
#include "widgets/playhead.h"

#include <algorithm>
#include <cmath>
#include <numeric>

/// Outlines, handles and names of the canvas's primitives, and which vertex is under the pointer.
namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double handleHitRadius = 8;
constexpr double bareHitRadius = 3; ///< of a vertex without a handle, between many others

constexpr std::size_t mostNames = 12; // more would hide what they name

std::array<LatticePoint, 3> cornersOf(const Triangle &triangle)
{
    return {triangle.vertices[0].position, triangle.vertices[1].position,
            triangle.vertices[2].position};
}

/// The nearest vertex to a position so far.
struct NearestVertex {
    std::optional<VertexRef> ref;
    double distance = handleHitRadius;

    /// Of equals the last, which is drawn on top.
    void offer(const VertexRef &vertex, const QPointF &way, double reach)
    {
        const double length = std::hypot(way.x(), way.y());
        if (length > std::min(distance, reach))
            return;
        ref = vertex;
        distance = length;
    }
};

} // namespace

std::optional<VertexRef> Canvas::vertexAt(const QPointF &position) const
{
    if (!view().contains(position))
        return std::nullopt;
    const OutlineChoice::InHand inHand = primitivesInHand();
    const QPointF reach(handleHitRadius, handleHitRadius);
    const SceneBox box = sceneBoxOf(QRectF(position - reach, position + reach), m_mapping);
    NearestVertex nearest;
    const auto offer = [&](int primitive, std::span<const Vertex> vertices) {
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (!box.contains(vertices[i].position))
                continue;
            const bool hasHandle = !m_outlines.isCrowded() || inHand.holds(primitive);
            nearest.offer({primitive, int(i)}, positionOf(vertices[i].position) - position,
                          hasHandle ? handleHitRadius : bareHitRadius);
        }
    };
    int primitive = 0;
    for (const Triangle &triangle : m_document->scene().triangles)
        offer(primitive++, triangle.vertices);
    for (const Shape &shape : m_document->scene().shapes)
        offer(primitive++, shape.vertices);
    offer(VertexRef::pending, m_document->pendingVertices());
    return nearest.ref;
}

/// Looked for once for each place of the pointer: a large scene has millions of vertices.
std::optional<VertexRef> Canvas::hoveredVertex()
{
    if (!m_hover || m_gesture)
        return std::nullopt;
    if (!m_hoveredVertex)
        m_hoveredVertex = vertexAt(*m_hover);
    return *m_hoveredVertex;
}

/// Without the vertex under the pointer.
OutlineChoice::InHand Canvas::primitivesInHand() const
{
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    const bool isThere = step && std::int64_t(step->primitive) < m_document->primitiveCount();
    return {m_document->selectedVertex(), std::nullopt,
            isThere ? std::optional(int(step->primitive)) : std::nullopt};
}

std::vector<int> Canvas::outlinedPrimitives()
{
    m_outlines.lookUp(*m_document, m_mapping, view());
    OutlineChoice::InHand inHand = primitivesInHand();
    inHand.hovered = hoveredVertex();
    return m_outlines.primitives(inHand);
}

std::optional<SetUpRecord> Canvas::setUpOf(int triangle) const
{
    const TracedScene *traced = tracedOfFrame();
    const auto index = std::size_t(triangle);
    // A drag may be ahead of the trace: numbers of a triangle that was there before are not shown.
    if (!traced || index >= traced->trace->primitiveCount()
        || traced->scene.triangles[index] != m_document->scene().triangles[index])
        return std::nullopt;
    return traced->trace->setUp(index);
}

/// The primitive whose vertices have names: of the selected vertex, else the one in hand.
std::optional<int> Canvas::namedPrimitive() const
{
    const int count = m_document->primitiveCount();
    if (const std::optional<VertexRef> ref = m_document->selectedVertex();
        ref && ref->primitive != VertexRef::pending)
        return ref->primitive;
    if (count == 1)
        return 0;
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    return step && int(step->primitive) < count ? std::optional(int(step->primitive))
                                                : std::nullopt;
}

void Canvas::paintOutlines(FramePainter &frame)
{
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    const Scene &scene = m_document->scene();
    for (const int primitive : outlinedPrimitives()) {
        const auto index = std::size_t(primitive);
        if (index >= scene.triangles.size()) {
            Shape shape = scene.shapes[index - scene.triangles.size()];
            for (Vertex &vertex : shape.vertices)
                vertex.position = onSamples(vertex.position);
            frame.drawShapeOutline(shape);
            continue;
        }
        std::array<LatticePoint, 3> corners = cornersOf(scene.triangles[index]);
        for (LatticePoint &corner : corners)
            corner = onSamples(corner);
        const bool isInHand = step && step->primitive == index;
        const std::optional<SetUpRecord> setUp = isInHand ? setUpOf(primitive) : std::nullopt;
        frame.drawOutline(corners, setUp ? rolesOf(*setUp) : EdgeRoles{});
    }
}

void Canvas::paintHandles(FramePainter &frame)
{
    const std::optional<VertexRef> hovered = hoveredVertex();
    const auto paint = [&](const VertexRef &ref, const Vertex &vertex) {
        HandleState state = HandleState::Idle;
        if (ref == m_document->selectedVertex())
            state = HandleState::Selected;
        else if (ref == hovered)
            state = HandleState::Hovered;
        frame.drawHandle(onSamples(vertex.position), vertex.colour, state);
    };
    for (const int primitive : outlinedPrimitives()) {
        const std::vector<Vertex> vertices = m_document->verticesOf(primitive);
        for (std::size_t i = 0; i < vertices.size(); ++i)
            paint({primitive, int(i)}, vertices[i]);
    }
    const std::vector<Vertex> &pending = m_document->pendingVertices();
    for (std::size_t i = 0; i < pending.size(); ++i)
        paint({VertexRef::pending, int(i)}, pending[i]);
    if (const std::optional<int> named = namedPrimitive())
        paintNamesOf(*named, frame);
}

/// P0, P1, P2 of a triangle in the order in which the method sorts them, of a shape as they stand.
void Canvas::paintNamesOf(int primitive, FramePainter &frame)
{
    const std::vector<Vertex> vertices = m_document->verticesOf(primitive);
    std::vector<std::size_t> order(vertices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (m_document->kindOf(primitive) == PrimitiveKind::Triangle) {
        const std::optional<SetUpRecord> setUp = setUpOf(primitive);
        const std::array<int, 3> sorted = setUp
            ? setUp->order
            : sortedByColumn(m_document->scene().triangles[std::size_t(primitive)]);
        std::ranges::copy(sorted, order.begin());
    }
    QPointF inside;
    for (const Vertex &vertex : vertices)
        inside += positionOf(vertex.position) / double(vertices.size());
    for (std::size_t rank = 0; rank < std::min(order.size(), mostNames); ++rank)
        frame.drawVertexName(QStringLiteral("P%1").arg(rank),
                             onSamples(vertices[order[rank]].position), inside);
}

} // namespace pixelplumb
