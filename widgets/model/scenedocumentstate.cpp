// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/plan/requirements.h"
#include "widgets/look/corewords.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/scenepiece.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace pixelplumb {

namespace {

constexpr int noState = -1; ///< of the scene

PrimitiveKind kindPlacedWith(const Method &method)
{
    return method.kinds.empty() ? PrimitiveKind::Triangle : method.kinds.front();
}

bool antialiasesLines(const Method &method)
{
    return method.draws(PrimitiveKind::Line)
        && std::ranges::count(method.effects, Effect::Antialiasing) > 0;
}

} // namespace

std::shared_ptr<const Scene> SceneDocument::snapshot() const
{
    if (!m_snapshot)
        m_snapshot = std::make_shared<const Scene>(m_scene);
    return m_snapshot;
}

std::shared_ptr<const Scene> SceneDocument::currentSnapshot() const
{
    if (m_currentFrame == 0)
        return snapshot(); // results are tied to this very object
    return std::make_shared<const Scene>(sceneAtFrame(*snapshot(), m_currentFrame));
}

LatticePoint SceneDocument::atCurrentFrame(const LatticePoint &point) const
{
    return {point.x + m_way.x, point.y + m_way.y};
}

LatticePoint SceneDocument::fromCurrentFrame(const LatticePoint &place) const
{
    return {place.x - m_way.x, place.y - m_way.y};
}

void SceneDocument::setCurrentFrame(int frame)
{
    const int before = std::exchange(m_currentFrame, frame);
    followMotion();
    if (m_currentFrame != before)
        emit currentFrameChanged();
}

/// Derives the offset from a triangle at the origin, so that it is rounded like the scene's.
void SceneDocument::followMotion()
{
    Scene origin;
    origin.motion = m_scene.motion;
    origin.triangles.resize(1);
    const int last = m_scene.motion ? m_scene.motion->frames - 1 : 0;
    m_currentFrame = std::clamp(m_currentFrame, 0, last);
    m_way = sceneAtFrame(origin, m_currentFrame).triangles.front().vertices[0].position;
}

void SceneDocument::tellSceneChanged()
{
    m_snapshot.reset();
    followMotion();
    emit sceneChanged();
}

void SceneDocument::markSaved()
{
    m_undoStack.setClean();
    m_savedState = m_state;
    m_savedScene = snapshot();
    m_savedPending = m_pending;
    tellModified();
}

void SceneDocument::markUnsaved()
{
    m_undoStack.resetClean();
    m_savedState = noState;
    m_savedScene.reset();
    tellModified();
}

bool SceneDocument::isModified() const
{
    return m_pending != m_savedPending || (m_state != m_savedState && !hasSavedScene());
}

/// Whether the scene is the saved one, perhaps by another method and the settings it supports.
bool SceneDocument::hasSavedScene() const
{
    if (!m_savedScene)
        return false;
    const Scene &saved = *m_savedScene;
    ScenePiece before = pixelplumb::pieceAtEnd(saved);
    before.scene.method = m_scene.method;
    if (const Method *method = methodNamed(QString::fromStdString(m_scene.method)))
        before.scene.settings = method->adapted(saved.settings);
    return before == pixelplumb::pieceAtEnd(m_scene) && saved.triangles == m_scene.triangles
        && saved.attributes == m_scene.attributes && saved.solids == m_scene.solids
        && saved.shapes == m_scene.shapes;
}

void SceneDocument::tellModified()
{
    if (isModified() == m_toldModified)
        return;
    m_toldModified = !m_toldModified;
    emit modifiedChanged(m_toldModified);
}

PrimitiveKind SceneDocument::placedKind() const
{
    const Method *method = methodNamed(QString::fromStdString(m_scene.method));
    return method ? kindPlacedWith(*method) : PrimitiveKind::Triangle;
}

void SceneDocument::setSettings(const ScanSettings &settings)
{
    const Method *method = methodNamed(QString::fromStdString(m_scene.method));
    const ScanSettings kept = method ? method->adapted(settings) : settings;
    edit(tr("change settings"), pieceAtEnd(),
         [&](ScenePiece &piece) { piece.scene.settings = kept; });
    tellAdaptation(settings);
}

void SceneDocument::setMethod(const std::string &method)
{
    if (method == m_scene.method)
        return;
    const QString name = QString::fromStdString(method);
    const Method *chosen = methodNamed(name);
    if (!chosen) {
        emit refused(tr("There is no method “%1”.").arg(name));
        return;
    }
    const ScanSettings asked = m_scene.settings;
    const ScenePiece before = pieceAtEnd();
    ScenePiece after = before;
    after.scene.settings = chosen->adapted(asked);
    after.scene.method = method;
    if (kindPlacedWith(*chosen) != placedKind())
        after.pending.clear();
    m_undoStack.push(new SceneEdit(*this, tr("change method"), before, after, std::nullopt,
                                   SceneEdit::Of::View));
    tellAdaptation(asked);
    if (antialiasesLines(*chosen) && antialiasingOf(m_scene.appearance) == Antialiasing::None)
        emit notice(
            tr("With one sample a pixel, lines have stairs and differ from the truth, which "
               "is the nearest pixels: Effects ▸ exact area makes them even."));
    const auto dropped = int(before.pending.size() - after.pending.size());
    if (dropped > 0)
        emit verticesDropped(
            tr("%n waiting vertices dropped: “%1” draws another kind of primitive. "
               "Undo brings them back.",
               nullptr, dropped)
                .arg(methodTitle(*chosen)));
}

void SceneDocument::tellAdaptation(const ScanSettings &asked)
{
    const Method *method = methodNamed(QString::fromStdString(m_scene.method));
    const QString note = method ? adaptationNote(*method, asked) : QString();
    if (!note.isEmpty())
        emit notice(note);
}

void SceneDocument::setSolid(std::size_t index, const Solid &solid, int drag)
{
    if (index >= m_scene.solids.size())
        return;
    edit(
        tr("change solid"), withPending(pieceWithSolids(m_scene, index, 1)),
        [&](ScenePiece &piece) { piece.scene.solids = {solid}; }, Drag{VertexRef(), drag});
}

void SceneDocument::setSolidShown(std::size_t index, bool shown)
{
    if (index >= m_scene.solids.size() || m_scene.solids[index].isHidden != shown)
        return;
    edit(shown ? tr("show solid") : tr("hide solid"),
         withPending(pieceWithSolids(m_scene, index, 1)),
         [&](ScenePiece &piece) { piece.scene.solids.front().isHidden = !shown; });
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
    edit(tr("change drawing order"),
         withPending(pieceWithSolids(m_scene, first, std::size_t(std::abs(places)) + 1)),
         [&](ScenePiece &piece) { piece.rotate(places > 0 ? 1 : -1); });
}

void SceneDocument::deleteSolid(std::size_t index)
{
    if (index >= m_scene.solids.size())
        return;
    edit(tr("delete solid"), withPending(pieceWithSolids(m_scene, index, 1)),
         [&](ScenePiece &piece) { piece.scene.solids.clear(); });
}

} // namespace pixelplumb
