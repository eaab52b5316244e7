// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileorder.h"
#include "widgets/model/scenedocument.h"

#include <algorithm>

/// Primitives leave the picture, for good or temporarily. Hidden ones keep their places among the
/// drawn ones.
namespace pixelplumb {

namespace {

/// Whether a hidden primitive comes after a place among the drawn triangles, or shapes.
bool isBehind(const HiddenPrimitive &place, const HiddenPrimitive &each)
{
    return each.isTriangle() == place.isTriangle() && each.place > place.place;
}

/// Removes a primitive from those drawn.
HiddenPrimitive removed(Scene &scene, int primitive)
{
    HiddenPrimitive taken = take(scene, primitive);
    for (HiddenPrimitive &each : scene.hidden)
        each.place -= isBehind(taken, each) ? 1 : 0;
    return taken;
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
    const auto append = [&all](const Triangle &triangle, const TriangleAttributes &attributes) {
        insert(all, {all.triangles.size(), HiddenTriangle{triangle, attributes}});
    };
    visitTriangles(
        scene,
        [&](std::size_t index, const TriangleAttributes *attributes) {
            append(scene.triangles[index], attributes ? *attributes : TriangleAttributes());
        },
        [&](std::size_t index) {
            const auto &kept = std::get<HiddenTriangle>(scene.hidden[index].primitive);
            append(kept.triangle, kept.attributes);
        });
    visitShapes(
        scene, [&](std::size_t index) { all.shapes.push_back(scene.shapes[index]); },
        [&](std::size_t index) {
            all.shapes.push_back(std::get<Shape>(scene.hidden[index].primitive));
        });
    return all;
}

} // namespace

void SceneDocument::movePrimitive(int primitive, int places)
{
    if (places == 0 || !canMovePrimitive(primitive, places))
        return;
    editScene(tr("change drawing order"), [&](Scene &changed) {
        HiddenPrimitive moved = take(changed, primitive);
        moved.place += std::size_t(places);
        insert(changed, moved);
    });
}

void SceneDocument::deletePrimitive(int primitive)
{
    if (primitive >= 0 && primitive < primitiveCount())
        editScene(tr("delete primitive"), [&](Scene &changed) { removed(changed, primitive); });
}

void SceneDocument::hidePrimitive(int primitive)
{
    if (primitive < 0 || primitive >= primitiveCount())
        return;
    editScene(tr("hide primitive"), [&](Scene &changed) {
        const auto triangles = int(changed.triangles.size());
        const bool isTriangle = primitive < triangles;
        const auto place = std::size_t(isTriangle ? primitive : primitive - triangles);
        const auto later = std::ranges::find_if(changed.hidden, [&](const HiddenPrimitive &each) {
            return each.isTriangle() == isTriangle ? each.place > place : isTriangle;
        });
        const auto index = later - changed.hidden.begin();
        const HiddenPrimitive hidden = removed(changed, primitive);
        changed.hidden.insert(changed.hidden.begin() + index, hidden);
    });
}

void SceneDocument::showHidden(int index)
{
    if (index < 0 || index >= hiddenCount())
        return;
    editScene(tr("show primitive"), [&](Scene &changed) {
        const HiddenPrimitive shown = changed.hidden[std::size_t(index)];
        auto later = changed.hidden.erase(changed.hidden.begin() + index);
        for (; later != changed.hidden.end(); ++later)
            later->place += later->isTriangle() == shown.isTriangle() ? 1 : 0;
        insert(changed, shown);
    });
}

void SceneDocument::showAllHidden()
{
    if (scene().hiddenCount() > 0)
        setScene(allShown(scene()), tr("show all primitives"));
}

void SceneDocument::deleteHidden(int index)
{
    if (index >= 0 && index < hiddenCount())
        editScene(tr("delete primitive"),
                  [&](Scene &changed) { changed.hidden.erase(changed.hidden.begin() + index); });
}

} // namespace pixelplumb
