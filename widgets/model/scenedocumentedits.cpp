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

void SceneDocument::edit(const QString &text, const ScenePiece &before,
                         const std::function<void(ScenePiece &)> &change,
                         const std::optional<Drag> &drag)
{
    ScenePiece after = before;
    change(after);
    if (after != before)
        m_undoStack.push(new SceneEdit(*this, text, before, after, drag));
}

void SceneDocument::placeVertex(const LatticePoint &position)
{
    if (!accepts(position))
        return;
    edit(tr("place vertex"), pieceAtEnd(), [&](ScenePiece &piece) {
        piece.pending.push_back({position, nextColour()});
        if (hasOneColour(placedKind())) { // the colour may have been chosen anew
            for (Vertex &vertex : piece.pending)
                vertex.colour = nextColour();
        }
        piece.chosenColour.reset();
        const std::optional<std::size_t> needed = placedVertexCount(placedKind());
        if (needed && piece.pending.size() >= *needed)
            piece.completePending(placedKind());
    });
}

void SceneDocument::moveVertex(const VertexRef &ref, const LatticePoint &position, int drag)
{
    const std::optional<Vertex> vertex = vertexAt(ref);
    if (!vertex || vertex->position == position || !accepts(position))
        return;
    edit(
        tr("move vertex"), pieceWith(ref.primitive),
        [&](ScenePiece &piece) {
            if (piece.scene.shapes.empty())
                piece.vertex(ref).position = position;
            else
                pixelplumb::moveVertex(piece.scene.shapes.front(), std::size_t(ref.vertex),
                                       position);
        },
        Drag{ref, drag});
}

void SceneDocument::setVertexColour(const VertexRef &ref, const Colour &colour)
{
    const std::optional<Vertex> vertex = vertexAt(ref);
    if (!vertex)
        return;
    if (ref.primitive != VertexRef::pending && hasOneColour(kindOf(ref.primitive)))
        return setPrimitiveColour(ref.primitive, colour);
    edit(tr("change colour"), pieceWith(ref.primitive),
         [&](ScenePiece &piece) { piece.vertex(ref).colour = colour; });
}

void SceneDocument::setPrimitiveColour(int primitive, const Colour &colour)
{
    if (primitive < 0 || primitive >= primitiveCount())
        return;
    edit(tr("change colour"), pieceWith(primitive), [&](ScenePiece &piece) {
        for (int vertex = 0; vertex < int(verticesOf(primitive).size()); ++vertex)
            piece.vertex({primitive, vertex}).colour = colour;
    });
}

void SceneDocument::movePrimitive(int primitive, int places)
{
    if (places == 0 || !canMovePrimitive(primitive, places))
        return;
    const auto first = std::size_t(std::min(primitive, primitive + places));
    edit(tr("change drawing order"),
         withPending(pieceWithRun(m_scene, first, std::size_t(std::abs(places)) + 1)),
         [&](ScenePiece &piece) { piece.rotate(places > 0 ? 1 : -1); });
}

void SceneDocument::addTriangle(const Triangle &triangle, const TriangleAttributes &attributes)
{
    if (!std::ranges::all_of(triangle.vertices,
                             [this](const Vertex &vertex) { return accepts(vertex.position); }))
        return;
    edit(tr("add triangle"), pieceAtEnd(),
         [&](ScenePiece &piece) { piece.setTriangle(triangle, attributes); });
}

void SceneDocument::setTriangle(int primitive, const Triangle &triangle,
                                const TriangleAttributes &attributes)
{
    if (kindOf(primitive) != PrimitiveKind::Triangle
        || !std::ranges::all_of(triangle.vertices,
                                [this](const Vertex &vertex) { return accepts(vertex.position); }))
        return;
    edit(tr("change triangle"), pieceWith(primitive),
         [&](ScenePiece &piece) { piece.setTriangle(triangle, attributes); });
}

void SceneDocument::closePending()
{
    if (!canClosePending())
        return;
    edit(tr("close polygon"), pieceAtEnd(),
         [&](ScenePiece &piece) { piece.completePending(PrimitiveKind::Polygon); });
}

void SceneDocument::setText(int primitive, const QString &text)
{
    if (primitive < 0 || primitive >= primitiveCount() || kindOf(primitive) != PrimitiveKind::Text
        || text.isEmpty())
        return;
    edit(tr("change text"), pieceWith(primitive),
         [&](ScenePiece &piece) { piece.scene.shapes.front().text = text.toStdString(); });
}

void SceneDocument::setForm(int primitive, const Shape &shape)
{
    edit(tr("change form"), pieceWith(primitive),
         [&](ScenePiece &piece) { piece.scene.shapes.front() = shape; });
}

void SceneDocument::deleteVertex(const VertexRef &ref)
{
    if (ref.primitive != VertexRef::pending) {
        deletePrimitive(ref.primitive);
        return;
    }
    if (!vertexAt(ref))
        return;
    edit(tr("delete vertex"), pieceAtEnd(),
         [&](ScenePiece &piece) { piece.pending.erase(piece.pending.begin() + ref.vertex); });
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
    edit(tr("discard vertices"), pieceAtEnd(), [&](ScenePiece &piece) { piece.pending.clear(); });
}

void SceneDocument::clear()
{
    if (m_pending.empty() && m_scene.isEmpty() && m_scene.hiddenCount() == 0)
        return;
    edit(tr("clear"), wholePiece(), [&](ScenePiece &piece) {
        piece.clearRun();
        piece.scene.hidden.clear();
        piece.scene.solids.clear();
        piece.pending.clear();
    });
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
    edit(tr("change frame"), pieceAtEnd(), [&](ScenePiece &piece) { piece.scene.frame = frame; });
}

void SceneDocument::setAppearance(const Appearance &appearance)
{
    edit(tr("change appearance"), pieceAtEnd(),
         [&](ScenePiece &piece) { piece.scene.appearance = appearance; });
}

void SceneDocument::setLook(const std::optional<Camera> &camera, const Appearance &appearance)
{
    edit(tr("change camera, light and materials"), pieceAtEnd(), [&](ScenePiece &piece) {
        piece.scene.camera = camera;
        piece.scene.appearance = appearance;
    });
}

void SceneDocument::setMotion(const std::optional<Motion> &motion)
{
    edit(motion ? tr("change motion") : tr("end motion"), pieceAtEnd(),
         [&](ScenePiece &piece) { piece.scene.motion = motion; });
}

void SceneDocument::moveOffScreenPoint(const LatticePoint &position, int drag)
{
    if (!pixelplumb::isWithinRange(position)) {
        emit refused(tr("The off-screen point lies beyond ±2^30 px."));
        return;
    }
    edit(
        tr("move off-screen point"), pieceAtEnd(),
        [&](ScenePiece &piece) { piece.scene.frame.offScreenPoint = position; },
        Drag{VertexRef(), drag});
}

} // namespace pixelplumb
