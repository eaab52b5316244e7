// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenecommands.h"

#include "core/geometry/shapeediting.h"

#include <algorithm>

namespace pixelplumb {

void SceneCommand::tellSceneChanged() { m_document->tellSceneChanged(); }

void SceneCommand::tellPendingChanged()
{
    emit m_document->pendingChanged();
    emit m_document->nextColourChanged();
}

void SceneCommand::tellSelectionChanged() { emit m_document->selectionChanged(); }

void SceneCommand::shiftSelection(int index, int by)
{
    if (selected() && selected()->primitive >= index) {
        selected()->primitive += by;
        tellSelectionChanged();
    }
}

SetTextCommand::SetTextCommand(SceneDocument &document, int primitive, const std::string &text)
    : SceneCommand(document, tr("change text"))
    , m_primitive(primitive)
    , m_text(text)
{
}

void SetTextCommand::exchange()
{
    std::swap(shape(m_primitive)->text, m_text);
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
    if (const Shape *moved = ref.primitive == VertexRef::pending ? nullptr : shape(ref.primitive))
        m_shapeBefore = *moved;
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

void MoveVertexCommand::redo()
{
    if (m_shapeBefore)
        moveVertex(*shape(m_ref.primitive), std::size_t(m_ref.vertex), m_after);
    else
        vertex(m_ref).position = m_after;
    tell();
}

void MoveVertexCommand::undo()
{
    if (m_shapeBefore)
        *shape(m_ref.primitive) = *m_shapeBefore;
    else
        vertex(m_ref).position = m_before;
    tell();
}

void MoveVertexCommand::tell()
{
    if (m_ref.primitive == VertexRef::pending)
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
    if (m_ref.primitive == VertexRef::pending)
        tellPendingChanged();
    else
        tellSceneChanged();
}

ReplaceVerticesCommand::ReplaceVerticesCommand(SceneDocument &document, const QString &text,
                                               Primitives primitives, std::vector<Vertex> pending)
    : SceneCommand(document, text)
    , m_primitives(std::move(primitives))
    , m_pending(std::move(pending))
{
}

void ReplaceVerticesCommand::exchange()
{
    const bool changesScene
        = m_primitives.triangles != scene().triangles || m_primitives.shapes != scene().shapes;
    std::swap(scene().triangles, m_primitives.triangles);
    std::swap(scene().shapes, m_primitives.shapes);
    std::swap(scene().attributes, m_primitives.attributes);
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
