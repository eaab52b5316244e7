// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapeediting.h"
#include "widgets/scenecommands.h"

/// Commands by which primitives come and go.
namespace pixelplumb {

void SceneCommand::completePending()
{
    const PrimitiveKind kind = placedKind();
    const bool wasPending = selected() && selected()->primitive == VertexRef::pending;
    int index = 0;
    if (kind == PrimitiveKind::Triangle) {
        index = int(scene().triangles.size());
        scene().triangles.push_back({{pending()[0], pending()[1], pending()[2]}});
        shiftSelection(index, 1);
    } else {
        scene().shapes.push_back(shapeFrom(kind, pending()));
        index = int(scene().triangles.size() + scene().shapes.size()) - 1;
    }
    pending().clear();
    if (wasPending)
        selected()->primitive = index;
}

void SceneCommand::reopenLast(PrimitiveKind kind)
{
    int index = int(scene().triangles.size() + scene().shapes.size()) - 1;
    if (kind == PrimitiveKind::Triangle) {
        index = int(scene().triangles.size()) - 1;
        const auto &vertices = scene().triangles.back().vertices;
        pending().assign(vertices.begin(), vertices.end());
        scene().triangles.pop_back();
    } else {
        pending() = scene().shapes.back().vertices;
        scene().shapes.pop_back();
    }
    if (selected() && selected()->primitive == index)
        selected()->primitive = VertexRef::pending;
    else
        shiftSelection(index, -1);
}

PlaceVertexCommand::PlaceVertexCommand(SceneDocument &document, const Vertex &vertex)
    : SceneCommand(document, tr("place vertex"))
    , m_vertex(vertex)
    , m_kind(placedKind())
    , m_chosenColour(chosenColour())
    , m_waiting(pending())
{
}

void PlaceVertexCommand::redo()
{
    chosenColour().reset();
    pending().push_back(m_vertex);
    const std::optional<std::size_t> needed = placedVertexCount(m_kind);
    const bool completes = needed && pending().size() >= *needed;
    if (completes)
        completePending();
    tellPendingChanged();
    if (completes)
        tellSceneChanged();
}

void PlaceVertexCommand::undo()
{
    chosenColour() = m_chosenColour;
    const bool completed = pending().empty();
    if (completed)
        reopenLast(m_kind);
    pending() = m_waiting;
    dropStaleSelection();
    tellPendingChanged();
    if (completed)
        tellSceneChanged();
}

ClosePolygonCommand::ClosePolygonCommand(SceneDocument &document)
    : SceneCommand(document, tr("close polygon"))
{
}

void ClosePolygonCommand::redo()
{
    completePending();
    tellPendingChanged();
    tellSceneChanged();
}

void ClosePolygonCommand::undo()
{
    reopenLast(PrimitiveKind::Polygon);
    tellPendingChanged();
    tellSceneChanged();
}

InsertTriangleCommand::InsertTriangleCommand(SceneDocument &document, const Triangle &triangle)
    : SceneCommand(document, tr("add triangle"))
    , m_triangle(triangle)
{
}

void InsertTriangleCommand::redo()
{
    shiftSelection(int(scene().triangles.size()), 1);
    scene().triangles.push_back(m_triangle);
    tellSceneChanged();
}

void InsertTriangleCommand::undo()
{
    scene().triangles.pop_back();
    const int index = int(scene().triangles.size());
    if (selected() && selected()->primitive == index) {
        selected().reset();
        tellSelectionChanged();
    }
    shiftSelection(index, -1);
    tellSceneChanged();
}

DeletePrimitiveCommand::DeletePrimitiveCommand(SceneDocument &document, int primitive)
    : SceneCommand(document, tr("delete primitive"))
    , m_index(primitive)
{
    m_attributes = scene().attributes;
    if (const Shape *deleted = shape(primitive)) {
        m_shape = *deleted;
        return;
    }
    m_triangle = scene().triangles[std::size_t(primitive)];
    const auto index = std::size_t(primitive);
    std::erase_if(m_attributes,
                  [index](const TriangleAttributes &each) { return each.triangle == index; });
    for (TriangleAttributes &each : m_attributes)
        each.triangle -= each.triangle > index ? 1 : 0;
}

void DeletePrimitiveCommand::redo()
{
    std::swap(scene().attributes, m_attributes);
    if (m_shape)
        scene().shapes.erase(scene().shapes.begin()
                             + (m_index - std::ptrdiff_t(scene().triangles.size())));
    else
        scene().triangles.erase(scene().triangles.begin() + m_index);
    if (selected() && selected()->primitive == m_index) {
        selected().reset();
        tellSelectionChanged();
    }
    shiftSelection(m_index, -1); // the same vertex has a new name
    tellSceneChanged();
}

void DeletePrimitiveCommand::undo()
{
    std::swap(scene().attributes, m_attributes);
    if (m_shape)
        scene().shapes.insert(scene().shapes.begin()
                                  + (m_index - std::ptrdiff_t(scene().triangles.size())),
                              *m_shape);
    else
        scene().triangles.insert(scene().triangles.begin() + m_index, m_triangle);
    shiftSelection(m_index, 1);
    tellSceneChanged();
}

} // namespace pixelplumb
