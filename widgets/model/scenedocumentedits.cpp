// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapeediting.h"
#include "widgets/model/renumbering.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/scenepiece.h"

#include <algorithm>

/// What a person can do to a document; each action is an edit on its undo stack.
namespace pixelplumb {

namespace {

bool isWithinRange(const FrameSpec &frame)
{
    return std::abs(std::int64_t(frame.firstColumn)) <= largestPixel
        && std::abs(std::int64_t(frame.firstRow)) <= largestPixel;
}

} // namespace

void SceneDocument::edit(const QString &text, const ScenePiece &before, const ScenePiece &after)
{
    m_undoStack.push(new SceneEdit(*this, text, before, after));
}

void SceneDocument::placeVertex(const LatticePoint &position)
{
    if (!accepts(position))
        return;
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.pending.push_back({position, nextColour()});
    if (hasOneColour(placedKind())) { // the colour may have been chosen anew
        for (Vertex &vertex : after.pending)
            vertex.colour = nextColour();
    }
    after.chosenColour.reset();
    const std::optional<std::size_t> needed = placedVertexCount(placedKind());
    if (needed && after.pending.size() >= *needed)
        after.completePending(placedKind());
    edit(tr("place vertex"), before, after);
}

void SceneDocument::moveVertex(const VertexRef &ref, const LatticePoint &position, int drag)
{
    const std::optional<Vertex> vertex = vertexAt(ref);
    if (!vertex || vertex->position == position || !accepts(position))
        return;
    const ScenePiece before = pieceWith(ref.primitive);
    ScenePiece after = before;
    if (after.run.shapes.empty())
        after.vertex(ref).position = position;
    else
        pixelplumb::moveVertex(after.run.shapes.front(), std::size_t(ref.vertex), position);
    if (after != before)
        m_undoStack.push(new SceneEdit(*this, tr("move vertex"), before, after, Drag{ref, drag}));
}

void SceneDocument::setVertexColour(const VertexRef &ref, const Colour &colour)
{
    const std::optional<Vertex> vertex = vertexAt(ref);
    if (!vertex || vertex->colour == colour)
        return;
    if (ref.primitive != VertexRef::pending && hasOneColour(kindOf(ref.primitive)))
        return setPrimitiveColour(ref.primitive, colour);
    const ScenePiece before = pieceWith(ref.primitive);
    ScenePiece after = before;
    after.vertex(ref).colour = colour;
    edit(tr("change colour"), before, after);
}

void SceneDocument::setPrimitiveColour(int primitive, const Colour &colour)
{
    if (primitive < 0 || primitive >= primitiveCount())
        return;
    const ScenePiece before = pieceWith(primitive);
    ScenePiece after = before;
    for (int vertex = 0; vertex < int(verticesOf(primitive).size()); ++vertex)
        after.vertex({primitive, vertex}).colour = colour;
    if (after != before)
        edit(tr("change colour"), before, after);
}

void SceneDocument::movePrimitive(int primitive, int places)
{
    if (places == 0 || !canMovePrimitive(primitive, places))
        return;
    const auto first = std::size_t(std::min(primitive, primitive + places));
    const ScenePiece before
        = withPending(pieceWithRun(m_scene, first, std::size_t(std::abs(places)) + 1));
    ScenePiece after = before;
    after.rotate(places > 0 ? 1 : -1);
    edit(tr("change drawing order"), before, after);
}

void SceneDocument::addTriangle(const Triangle &triangle, const TriangleAttributes &attributes)
{
    if (!std::ranges::all_of(triangle.vertices,
                             [this](const Vertex &vertex) { return accepts(vertex.position); }))
        return;
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.setTriangle(triangle, attributes);
    edit(tr("add triangle"), before, after);
}

void SceneDocument::setTriangle(int primitive, const Triangle &triangle,
                                const TriangleAttributes &attributes)
{
    if (kindOf(primitive) != PrimitiveKind::Triangle
        || !std::ranges::all_of(triangle.vertices,
                                [this](const Vertex &vertex) { return accepts(vertex.position); }))
        return;
    const ScenePiece before = pieceWith(primitive);
    ScenePiece after = before;
    after.setTriangle(triangle, attributes);
    if (after != before)
        edit(tr("change triangle"), before, after);
}

void SceneDocument::closePending()
{
    if (!canClosePending())
        return;
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.completePending(PrimitiveKind::Polygon);
    edit(tr("close polygon"), before, after);
}

void SceneDocument::setText(int primitive, const QString &text)
{
    if (primitive < 0 || primitive >= primitiveCount() || kindOf(primitive) != PrimitiveKind::Text
        || text.isEmpty())
        return;
    const ScenePiece before = pieceWith(primitive);
    ScenePiece after = before;
    after.run.shapes.front().text = text.toStdString();
    if (after != before)
        edit(tr("change text"), before, after);
}

void SceneDocument::setForm(int primitive, const Shape &shape)
{
    const ScenePiece before = pieceWith(primitive);
    ScenePiece after = before;
    after.run.shapes.front() = shape;
    if (after != before)
        edit(tr("change form"), before, after);
}

void SceneDocument::deleteVertex(const VertexRef &ref)
{
    if (ref.primitive != VertexRef::pending) {
        deletePrimitive(ref.primitive);
        return;
    }
    if (!vertexAt(ref))
        return;
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.pending.erase(after.pending.begin() + ref.vertex);
    edit(tr("delete vertex"), before, after);
}

/// Pending vertices are undone edit by edit, so that the next undo concerns what came before them;
/// if something else was done since, discarding them is an edit of its own.
void SceneDocument::discardPending()
{
    const auto isOfPending = [this] {
        const int last = m_undoStack.index() - 1;
        const auto *edit
            = last >= 0 ? dynamic_cast<const SceneEdit *>(m_undoStack.command(last)) : nullptr;
        return edit && edit->keepsScene();
    };
    while (!m_pending.empty() && isOfPending())
        m_undoStack.undo();
    if (m_pending.empty())
        return;
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.pending.clear();
    edit(tr("discard vertices"), before, after);
}

void SceneDocument::clear()
{
    if (m_pending.empty() && m_scene.isEmpty() && m_scene.hiddenCount() == 0)
        return;
    const ScenePiece before = wholePiece();
    ScenePiece after = before;
    after.run = {};
    after.hidden.clear();
    after.solids.clear();
    after.pending.clear();
    edit(tr("clear"), before, after);
}

void SceneDocument::setFrame(const FrameSpec &frame)
{
    if (frame == m_scene.frame)
        return;
    if (frame.width < 1 || frame.height < 1 || frame.width > largestFrameSide
        || frame.height > largestFrameSide
        || std::int64_t(frame.width) * frame.height > largestFrameArea) {
        emit refused(
            tr("A frame of %1 × %2 pixels cannot be made: each side must be 1 to %3 and the "
               "area at most %4.")
                .arg(frame.width)
                .arg(frame.height)
                .arg(largestFrameSide)
                .arg(largestFrameArea));
        return;
    }
    if (!isWithinRange(frame)) {
        emit refused(tr("The frame's first pixel (%1, %2) lies beyond ±2^30 px.")
                         .arg(frame.firstColumn)
                         .arg(frame.firstRow));
        return;
    }
    if (frame.offScreenPoint && !pixelplumb::isWithinRange(*frame.offScreenPoint)) {
        emit refused(tr("The off-screen point lies beyond ±2^30 px."));
        return;
    }
    ScenePiece after = pieceAtEnd();
    after.frame = frame;
    edit(tr("change frame"), pieceAtEnd(), after);
}

void SceneDocument::setCamera(const Camera &camera, int drag)
{
    if (m_scene.camera == camera)
        return;
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.camera = camera;
    m_undoStack.push(
        new SceneEdit(*this, tr("move camera"), before, after, Drag{VertexRef(), drag}));
}

void SceneDocument::setAppearance(const Appearance &appearance)
{
    if (m_scene.appearance == appearance)
        return;
    ScenePiece after = pieceAtEnd();
    after.appearance = appearance;
    edit(tr("change appearance"), pieceAtEnd(), after);
}

void SceneDocument::setLook(const std::optional<Camera> &camera, const Appearance &appearance)
{
    if (m_scene.camera == camera && m_scene.appearance == appearance)
        return;
    ScenePiece after = pieceAtEnd();
    after.camera = camera;
    after.appearance = appearance;
    edit(tr("change camera, light and materials"), pieceAtEnd(), after);
}

void SceneDocument::setMotion(const std::optional<Motion> &motion)
{
    if (m_scene.motion == motion)
        return;
    ScenePiece after = pieceAtEnd();
    after.motion = motion;
    edit(motion ? tr("change motion") : tr("end motion"), pieceAtEnd(), after);
}

void SceneDocument::moveOffScreenPoint(const LatticePoint &position, int drag)
{
    if (m_scene.frame.offScreenPoint == position)
        return;
    if (!pixelplumb::isWithinRange(position)) {
        emit refused(tr("The off-screen point lies beyond ±2^30 px."));
        return;
    }
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.frame.offScreenPoint = position;
    m_undoStack.push(
        new SceneEdit(*this, tr("move off-screen point"), before, after, Drag{VertexRef(), drag}));
}

} // namespace pixelplumb
