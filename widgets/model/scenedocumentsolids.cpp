// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenedocument.h"
#include "widgets/model/sceneedit.h"

#include <cstdlib>

/// Edits of solids, camera and other things in space.
namespace pixelplumb {

void SceneDocument::setSolid(std::size_t index, const Solid &solid, int drag)
{
    if (index >= m_scene.solids.size() || m_scene.solids[index] == solid)
        return;
    const ScenePiece before = withPending(pieceWithSolids(m_scene, index, 1));
    ScenePiece after = before;
    after.solids = {solid};
    m_undoStack.push(
        new SceneEdit(*this, tr("change solid"), before, after, Drag{VertexRef(), drag}));
}

void SceneDocument::setSolidShown(std::size_t index, bool shown)
{
    if (index >= m_scene.solids.size() || m_scene.solids[index].isHidden != shown)
        return;
    const ScenePiece before = withPending(pieceWithSolids(m_scene, index, 1));
    ScenePiece after = before;
    after.solids.front().isHidden = !shown;
    edit(shown ? tr("show solid") : tr("hide solid"), before, after);
}

bool SceneDocument::canMoveSolid(std::size_t index, int places) const
{
    const auto count = std::ptrdiff_t(m_scene.solids.size());
    const auto from = std::ptrdiff_t(index);
    return from < count && from + places >= 0 && from + places < count;
}

void SceneDocument::moveSolid(std::size_t index, int places)
{
    if (places == 0 || !canMoveSolid(index, places))
        return;
    const std::size_t first = places > 0 ? index : index - std::size_t(-places);
    const ScenePiece before
        = withPending(pieceWithSolids(m_scene, first, std::size_t(std::abs(places)) + 1));
    ScenePiece after = before;
    after.rotate(places > 0 ? 1 : -1);
    edit(tr("change drawing order"), before, after);
}

void SceneDocument::deleteSolid(std::size_t index)
{
    if (index >= m_scene.solids.size())
        return;
    const ScenePiece before = withPending(pieceWithSolids(m_scene, index, 1));
    ScenePiece after = before;
    after.solids.clear();
    edit(tr("delete solid"), before, after);
}

} // namespace pixelplumb
