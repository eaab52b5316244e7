// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenepiece.h"

#include "core/geometry/shapeediting.h"
#include "core/methods/method.h"
#include "widgets/model/scenedocument.h"

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

template <class Element>
void replaceRun(std::vector<Element> &all, std::size_t first, std::size_t count,
                const std::vector<Element> &run)
{
    const auto begin = all.begin() + std::ptrdiff_t(first);
    if (run.size() == count) {
        std::ranges::copy(run, begin);
        return;
    }
    const auto place = all.erase(begin, begin + std::ptrdiff_t(count));
    all.insert(place, run.begin(), run.end());
}

/// The range of the attributes of the triangles [first, end).
auto placesOfAttributes(auto &attributes, std::size_t first, std::size_t end)
{
    const auto placeOf = [&attributes](std::size_t triangle) {
        return std::ranges::lower_bound(attributes, triangle, {}, &TriangleAttributes::triangle);
    };
    return std::pair(placeOf(first), placeOf(end));
}

void replaceAttributes(std::vector<TriangleAttributes> &all, const ScenePiece &before,
                       const ScenePiece &after)
{
    const std::size_t first = before.firstTriangle;
    const std::size_t removed = before.scene.triangles.size();
    const std::size_t inserted = after.scene.triangles.size();
    if (removed == inserted && before.scene.attributes == after.scene.attributes)
        return;
    const auto [begin, end] = placesOfAttributes(all, first, first + removed);
    for (auto behind = end; behind != all.end(); ++behind)
        behind->triangle += inserted - removed;
    const auto place = all.erase(begin, end);
    all.insert(place, after.scene.attributes.begin(), after.scene.attributes.end());
}

} // namespace

void ScenePiece::clearRun()
{
    scene.triangles.clear();
    scene.attributes.clear();
    scene.shapes.clear();
}

void ScenePiece::completePending(PrimitiveKind kind)
{
    const Method *drawing = methodNamed(QString::fromStdString(scene.method));
    if (kind == PrimitiveKind::Triangle)
        scene.triangles.push_back({{pending[0], pending[1], pending[2]}});
    else
        scene.shapes.push_back(
            shapeFrom(kind, pending, drawing ? drawing->fills : std::vector<ShapeFill>()));
    pending.clear();
}

void ScenePiece::rotate(int by)
{
    const auto rotated = [by](auto &all) {
        if (!all.empty())
            std::rotate(all.begin(), by > 0 ? all.begin() + 1 : all.end() - 1, all.end());
    };
    rotated(scene.triangles);
    rotated(scene.shapes);
    rotated(scene.solids);
    const std::size_t count = scene.triangles.size();
    for (TriangleAttributes &each : scene.attributes) {
        const std::size_t place = each.triangle - firstTriangle;
        each.triangle = firstTriangle + (by > 0 ? place + count - 1 : place + 1) % count;
    }
    std::ranges::sort(scene.attributes, {}, &TriangleAttributes::triangle);
}

void ScenePiece::setTriangle(const Triangle &triangle, TriangleAttributes attributes)
{
    scene.triangles = {triangle};
    attributes.triangle = firstTriangle;
    scene.attributes.clear();
    TriangleAttributes byDefault;
    byDefault.triangle = firstTriangle;
    if (attributes != byDefault)
        scene.attributes = {attributes};
}

Vertex &ScenePiece::vertex(const VertexRef &ref)
{
    const auto index = std::size_t(ref.vertex);
    if (ref.primitive == VertexRef::pending)
        return pending[index];
    return scene.shapes.empty() ? scene.triangles.front().vertices[index]
                                : scene.shapes.front().vertices[index];
}

ScenePiece pieceAtEnd(const Scene &scene)
{
    ScenePiece piece;
    piece.scene.frame = scene.frame;
    piece.scene.settings = scene.settings;
    piece.scene.method = scene.method;
    piece.scene.camera = scene.camera;
    piece.scene.appearance = scene.appearance;
    piece.scene.motion = scene.motion;
    piece.scene.hidden = scene.hidden;
    piece.firstTriangle = scene.triangles.size();
    piece.firstSolid = scene.solids.size();
    piece.firstShape = scene.shapes.size();
    return piece;
}

ScenePiece pieceWith(const Scene &scene, std::size_t primitive)
{
    return pieceWithRun(scene, primitive, 1);
}

ScenePiece pieceWithRun(const Scene &scene, std::size_t first, std::size_t count)
{
    ScenePiece piece = pieceAtEnd(scene);
    if (first >= scene.triangles.size()) {
        piece.firstShape = first - scene.triangles.size();
        const auto begin = scene.shapes.begin() + std::ptrdiff_t(piece.firstShape);
        piece.scene.shapes.assign(begin, begin + std::ptrdiff_t(count));
        return piece;
    }
    piece.firstTriangle = first;
    const auto triangles = scene.triangles.begin() + std::ptrdiff_t(first);
    piece.scene.triangles.assign(triangles, triangles + std::ptrdiff_t(count));
    const auto [begin, end] = placesOfAttributes(scene.attributes, first, first + count);
    piece.scene.attributes.assign(begin, end);
    return piece;
}

ScenePiece pieceWithSolids(const Scene &scene, std::size_t first, std::size_t count)
{
    ScenePiece piece = pieceAtEnd(scene);
    piece.firstSolid = first;
    const auto begin = scene.solids.begin() + std::ptrdiff_t(first);
    piece.scene.solids.assign(begin, begin + std::ptrdiff_t(count));
    return piece;
}

ScenePiece wholePiece(const Scene &scene)
{
    ScenePiece piece;
    piece.scene = scene;
    return piece;
}

void replace(Scene &scene, const ScenePiece &before, const ScenePiece &after)
{
    Scene next = after.scene;
    next.triangles = std::move(scene.triangles);
    next.attributes = std::move(scene.attributes);
    next.solids = std::move(scene.solids);
    next.shapes = std::move(scene.shapes);
    replaceAttributes(next.attributes, before, after);
    replaceRun(next.triangles, before.firstTriangle, before.scene.triangles.size(),
               after.scene.triangles);
    replaceRun(next.solids, before.firstSolid, before.scene.solids.size(), after.scene.solids);
    replaceRun(next.shapes, before.firstShape, before.scene.shapes.size(), after.scene.shapes);
    scene = std::move(next);
}

SceneEdit::SceneEdit(SceneDocument &document, const QString &text, ScenePiece before,
                     ScenePiece after, const std::optional<Drag> &drag, Of of)
    : QUndoCommand(text)
    , m_document(&document)
    , m_before(std::move(before))
    , m_after(std::move(after))
    , m_stateBefore(document.m_state)
    , m_stateAfter(of == Of::View || m_before.hasSceneOf(m_after) ? m_stateBefore
                                                                  : ++document.m_lastState)
    , m_drag(drag)
{
}

void SceneEdit::redo() { m_document->exchange(m_before, m_after, m_stateAfter); }

void SceneEdit::undo() { m_document->exchange(m_after, m_before, m_stateBefore); }

bool SceneEdit::mergeWith(const QUndoCommand *other)
{
    const auto &edit = static_cast<const SceneEdit &>(*other);
    if (edit.m_drag != m_drag)
        return false;
    m_after = edit.m_after;
    m_stateAfter = edit.m_stateAfter;
    if (m_after == m_before) { // a drag that returned changed nothing
        setObsolete(true);
        m_document->m_state = m_stateBefore;
        m_document->tellModified();
    }
    return true;
}

} // namespace pixelplumb
