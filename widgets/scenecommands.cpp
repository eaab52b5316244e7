// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenecommands.h"

#include <algorithm>

namespace pixelplumb {

void SceneCommand::tellSceneChanged() { emit m_document->sceneChanged(); }

void SceneCommand::tellPendingChanged()
{
    emit m_document->pendingChanged();
    emit m_document->nextColourChanged();
}

void SceneCommand::tellSelectionChanged() { emit m_document->selectionChanged(); }

PlaceVertexCommand::PlaceVertexCommand(SceneDocument &document, const Vertex &vertex)
    : SceneCommand(document, tr("place vertex"))
    , m_vertex(vertex)
    , m_chosenColour(chosenColour())
{
}

void PlaceVertexCommand::redo()
{
    chosenColour().reset();
    pending().push_back(m_vertex);
    if (pending().size() < 3) {
        tellPendingChanged();
        return;
    }
    scene().triangles.push_back({{pending()[0], pending()[1], pending()[2]}});
    pending().clear();
    if (selected() && selected()->triangle == VertexRef::pending)
        selected()->triangle = int(scene().triangles.size()) - 1;
    tellPendingChanged();
    tellSceneChanged();
}

void PlaceVertexCommand::undo()
{
    chosenColour() = m_chosenColour;
    const bool completedTriangle = pending().empty();
    if (completedTriangle) {
        const int triangle = int(scene().triangles.size()) - 1;
        const auto &vertices = scene().triangles.back().vertices;
        pending().assign(vertices.begin(), vertices.end());
        scene().triangles.pop_back();
        if (selected() && selected()->triangle == triangle)
            selected()->triangle = VertexRef::pending;
    }
    pending().pop_back();
    dropStaleSelection();
    tellPendingChanged();
    if (completedTriangle)
        tellSceneChanged();
}

MoveVertexCommand::MoveVertexCommand(SceneDocument &document, const VertexRef &ref,
                                     const LatticePoint &position, int drag)
    : SceneCommand(document, tr("move vertex"))
    , m_ref(ref)
    , m_before(vertex(ref).position)
    , m_after(position)
    , m_drag(drag)
{
}

bool MoveVertexCommand::mergeWith(const QUndoCommand *other)
{
    const auto &move = static_cast<const MoveVertexCommand &>(*other);
    if (move.m_ref != m_ref || move.m_drag != m_drag)
        return false;
    m_after = move.m_after;
    setObsolete(m_after == m_before); // a drag that came back changed nothing
    return true;
}

void MoveVertexCommand::moveTo(const LatticePoint &position)
{
    vertex(m_ref).position = position;
    if (m_ref.triangle == VertexRef::pending)
        tellPendingChanged();
    else
        tellSceneChanged();
}

SetVertexColourCommand::SetVertexColourCommand(SceneDocument &document, const VertexRef &ref,
                                               const Colour &colour)
    : SceneCommand(document, tr("change colour"))
    , m_ref(ref)
    , m_colour(colour)
{
}

void SetVertexColourCommand::exchange()
{
    std::swap(vertex(m_ref).colour, m_colour);
    if (m_ref.triangle == VertexRef::pending)
        tellPendingChanged();
    else
        tellSceneChanged();
}

InsertTriangleCommand::InsertTriangleCommand(SceneDocument &document, const Triangle &triangle)
    : SceneCommand(document, tr("add triangle"))
    , m_triangle(triangle)
{
}

void InsertTriangleCommand::redo()
{
    scene().triangles.push_back(m_triangle);
    tellSceneChanged();
}

void InsertTriangleCommand::undo()
{
    scene().triangles.pop_back();
    dropStaleSelection();
    tellSceneChanged();
}

DeleteTriangleCommand::DeleteTriangleCommand(SceneDocument &document, int triangle)
    : SceneCommand(document, tr("delete triangle"))
    , m_index(triangle)
    , m_triangle(scene().triangles[std::size_t(triangle)])
{
}

void DeleteTriangleCommand::redo()
{
    scene().triangles.erase(scene().triangles.begin() + m_index);
    if (selected() && selected()->triangle == m_index) {
        selected().reset();
        tellSelectionChanged();
    } else if (selected() && selected()->triangle > m_index) {
        --selected()->triangle; // the same vertex has a new name
        tellSelectionChanged();
    }
    tellSceneChanged();
}

void DeleteTriangleCommand::undo()
{
    scene().triangles.insert(scene().triangles.begin() + m_index, m_triangle);
    if (selected() && selected()->triangle >= m_index) {
        ++selected()->triangle;
        tellSelectionChanged();
    }
    tellSceneChanged();
}

ReplaceVerticesCommand::ReplaceVerticesCommand(SceneDocument &document, const QString &text,
                                               std::vector<Triangle> triangles,
                                               std::vector<Vertex> pending)
    : SceneCommand(document, text)
    , m_triangles(std::move(triangles))
    , m_pending(std::move(pending))
{
}

void ReplaceVerticesCommand::exchange()
{
    const bool changesScene = m_triangles != scene().triangles;
    std::swap(scene().triangles, m_triangles);
    std::swap(pending(), m_pending);
    dropStaleSelection();
    tellPendingChanged();
    if (changesScene)
        tellSceneChanged();
}

SetUpSceneCommand::SetUpSceneCommand(SceneDocument &document, const QString &text,
                                     const Scene &scene)
    : SceneCommand(document, text)
    , m_frame(scene.frame)
    , m_settings(scene.settings)
    , m_method(scene.method)
{
}

void SetUpSceneCommand::exchange()
{
    std::swap(scene().frame, m_frame);
    std::swap(scene().settings, m_settings);
    std::swap(scene().method, m_method);
    tellSceneChanged();
}

} // namespace pixelplumb
