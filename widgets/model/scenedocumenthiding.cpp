// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileorder.h"
#include "widgets/model/scenedocument.h"

#include <algorithm>

/// Primitives leave the picture, for good or temporarily. Hidden ones keep their places among the
/// drawn ones.
namespace pixelplumb {

namespace {

/// The run's only primitive, with its place.
HiddenPrimitive onlyPrimitive(const ScenePiece &piece)
{
    if (!piece.scene.shapes.empty())
        return {piece.firstShape, piece.scene.shapes.front()};
    HiddenTriangle kept{piece.scene.triangles.front(), {}};
    if (!piece.scene.attributes.empty())
        kept.attributes = piece.scene.attributes.front();
    kept.attributes.triangle = 0;
    return {piece.firstTriangle, kept};
}

/// Selects hidden primitives after a place among the drawn triangles, or shapes.
auto behind(const HiddenPrimitive &place)
{
    return [&place](const HiddenPrimitive &each) {
        return each.isTriangle() == place.isTriangle() && each.place > place.place;
    };
}

/// Removes the run's only primitive from those drawn.
void removeRun(ScenePiece &piece)
{
    const HiddenPrimitive removed = onlyPrimitive(piece);
    piece.clearRun();
    for (HiddenPrimitive &each : piece.scene.hidden)
        each.place -= behind(removed)(each) ? 1 : 0;
}

/// The scene with the hidden primitives among those drawn.
Scene allShown(const Scene &scene)
{
    Scene all = scene;
    all.hidden.clear();
    all.triangles.clear();
    all.attributes.clear();
    all.shapes.clear();
    for (Solid &solid : all.solids)
        solid.isHidden = false;
    const auto appendTriangle = [&all](const Triangle &triangle, TriangleAttributes attributes) {
        attributes.triangle = 0;
        if (attributes != TriangleAttributes()) {
            attributes.triangle = all.triangles.size();
            all.attributes.push_back(attributes);
        }
        all.triangles.push_back(triangle);
    };
    visitTriangles(
        scene,
        [&](std::size_t index, const TriangleAttributes *attributes) {
            appendTriangle(scene.triangles[index], attributes ? *attributes : TriangleAttributes());
        },
        [&](std::size_t index) {
            const auto &kept = std::get<HiddenTriangle>(scene.hidden[index].primitive);
            appendTriangle(kept.triangle, kept.attributes);
        });
    visitShapes(
        scene, [&](std::size_t index) { all.shapes.push_back(scene.shapes[index]); },
        [&](std::size_t index) {
            all.shapes.push_back(std::get<Shape>(scene.hidden[index].primitive));
        });
    return all;
}

} // namespace

void SceneDocument::deletePrimitive(int primitive)
{
    if (primitive < 0 || primitive >= primitiveCount())
        return;
    edit(tr("delete primitive"), pieceWith(primitive),
         [&](ScenePiece &piece) { removeRun(piece); });
}

void SceneDocument::hidePrimitive(int primitive)
{
    if (primitive < 0 || primitive >= primitiveCount())
        return;
    const ScenePiece before = pieceWith(primitive);
    ScenePiece after = before;
    const HiddenPrimitive hidden = onlyPrimitive(before);
    const auto isBehind = [&hidden](const HiddenPrimitive &each) {
        return behind(hidden)(each) || (hidden.isTriangle() && !each.isTriangle());
    };
    after.scene.hidden.insert(std::ranges::find_if(after.scene.hidden, isBehind), hidden);
    removeRun(after);
    m_undoStack.push(new SceneEdit(*this, tr("hide primitive"), before, after));
}

void SceneDocument::showHidden(int index)
{
    if (index < 0 || index >= hiddenCount())
        return;
    ScenePiece before = pieceAtEnd();
    const HiddenPrimitive hidden = before.scene.hidden[std::size_t(index)];
    (hidden.isTriangle() ? before.firstTriangle : before.firstShape) = hidden.place;
    ScenePiece after = before;
    if (const auto *triangle = std::get_if<HiddenTriangle>(&hidden.primitive))
        after.setTriangle(triangle->triangle, triangle->attributes);
    else
        after.scene.shapes = {std::get<Shape>(hidden.primitive)};
    auto later = after.scene.hidden.erase(after.scene.hidden.begin() + index);
    for (; later != after.scene.hidden.end(); ++later) {
        if (later->isTriangle() == hidden.isTriangle())
            ++later->place;
    }
    m_undoStack.push(new SceneEdit(*this, tr("show primitive"), before, after));
}

void SceneDocument::showAllHidden()
{
    if (m_scene.hiddenCount() == 0)
        return;
    setScene(allShown(m_scene), tr("show all primitives"));
}

void SceneDocument::deleteHidden(int index)
{
    if (index < 0 || index >= hiddenCount())
        return;
    edit(tr("delete primitive"), pieceAtEnd(),
         [&](ScenePiece &piece) { piece.scene.hidden.erase(piece.scene.hidden.begin() + index); });
}

} // namespace pixelplumb
