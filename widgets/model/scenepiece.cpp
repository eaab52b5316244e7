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
    const std::size_t removed = before.run.triangles.size();
    const std::size_t inserted = after.run.triangles.size();
    if (removed == inserted && before.run.attributes == after.run.attributes)
        return;
    const auto [begin, end] = placesOfAttributes(all, first, first + removed);
    for (auto behind = end; behind != all.end(); ++behind)
        behind->triangle += inserted - removed;
    const auto place = all.erase(begin, end);
    all.insert(place, after.run.attributes.begin(), after.run.attributes.end());
}

} // namespace

void ScenePiece::completePending(PrimitiveKind kind)
{
    const Method *drawing = methodNamed(QString::fromStdString(method));
    if (kind == PrimitiveKind::Triangle)
        run.triangles.push_back({{pending[0], pending[1], pending[2]}});
    else
        run.shapes.push_back(
            shapeFrom(kind, pending, drawing ? drawing->fills : std::vector<ShapeFill>()));
    pending.clear();
}

void ScenePiece::rotate(int by)
{
    const auto rotated = [by](auto &all) {
        if (!all.empty())
            std::rotate(all.begin(), by > 0 ? all.begin() + 1 : all.end() - 1, all.end());
    };
    rotated(run.triangles);
    rotated(run.shapes);
    rotated(solids);
    const std::size_t count = run.triangles.size();
    for (TriangleAttributes &each : run.attributes) {
        const std::size_t place = each.triangle - firstTriangle;
        each.triangle = firstTriangle + (by > 0 ? place + count - 1 : place + 1) % count;
    }
    std::ranges::sort(run.attributes, {}, &TriangleAttributes::triangle);
}

void ScenePiece::setTriangle(const Triangle &triangle, TriangleAttributes attributes)
{
    run.triangles = {triangle};
    attributes.triangle = firstTriangle;
    run.attributes.clear();
    TriangleAttributes byDefault;
    byDefault.triangle = firstTriangle;
    if (attributes != byDefault)
        run.attributes = {attributes};
}

Vertex &ScenePiece::vertex(const VertexRef &ref)
{
    const auto index = std::size_t(ref.vertex);
    if (ref.primitive == VertexRef::pending)
        return pending[index];
    return run.shapes.empty() ? run.triangles.front().vertices[index]
                              : run.shapes.front().vertices[index];
}

bool ScenePiece::hasSceneOf(const ScenePiece &other) const
{
    return frame == other.frame && settings == other.settings && method == other.method
        && run == other.run && solids == other.solids && camera == other.camera
        && appearance == other.appearance && motion == other.motion && hidden == other.hidden;
}

bool solidsStay(const ScenePiece &before, const ScenePiece &after)
{
    return before.solids == after.solids
        || (before.solids.size() == 1 && after.solids.size() == 1
            && before.solids.front().isHidden == after.solids.front().isHidden);
}

ScenePiece pieceAtEnd(const Scene &scene)
{
    ScenePiece piece;
    piece.frame = scene.frame;
    piece.settings = scene.settings;
    piece.method = scene.method;
    piece.firstTriangle = scene.triangles.size();
    piece.firstSolid = scene.solids.size();
    piece.firstShape = scene.shapes.size();
    piece.camera = scene.camera;
    piece.appearance = scene.appearance;
    piece.motion = scene.motion;
    piece.hidden = scene.hidden;
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
        piece.run.shapes.assign(begin, begin + std::ptrdiff_t(count));
        return piece;
    }
    piece.firstTriangle = first;
    const auto triangles = scene.triangles.begin() + std::ptrdiff_t(first);
    piece.run.triangles.assign(triangles, triangles + std::ptrdiff_t(count));
    const auto [begin, end] = placesOfAttributes(scene.attributes, first, first + count);
    piece.run.attributes.assign(begin, end);
    return piece;
}

ScenePiece pieceWithSolids(const Scene &scene, std::size_t first, std::size_t count)
{
    ScenePiece piece = pieceAtEnd(scene);
    piece.firstSolid = first;
    const auto begin = scene.solids.begin() + std::ptrdiff_t(first);
    piece.solids.assign(begin, begin + std::ptrdiff_t(count));
    return piece;
}

ScenePiece wholePiece(const Scene &scene)
{
    ScenePiece piece = pieceAtEnd(scene);
    piece.firstTriangle = 0;
    piece.firstSolid = 0;
    piece.firstShape = 0;
    piece.run = {scene.triangles, scene.shapes, scene.attributes};
    piece.solids = scene.solids;
    return piece;
}

void replace(Scene &scene, const ScenePiece &before, const ScenePiece &after)
{
    scene.frame = after.frame;
    scene.settings = after.settings;
    scene.method = after.method;
    scene.camera = after.camera;
    scene.appearance = after.appearance;
    scene.motion = after.motion;
    scene.hidden = after.hidden;
    replaceAttributes(scene.attributes, before, after);
    replaceRun(scene.triangles, before.firstTriangle, before.run.triangles.size(),
               after.run.triangles);
    replaceRun(scene.solids, before.firstSolid, before.solids.size(), after.solids);
    replaceRun(scene.shapes, before.firstShape, before.run.shapes.size(), after.run.shapes);
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
