// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/plan/requirements.h"
#include "widgets/look/corewords.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace pixelplumb {

namespace {

constexpr int noNumber = -1; ///< of a state

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
    origin.motion = scene().motion;
    origin.triangles.resize(1);
    const int last = scene().motion ? scene().motion->frames - 1 : 0;
    m_currentFrame = std::clamp(m_currentFrame, 0, last);
    m_way = sceneAtFrame(origin, m_currentFrame).triangles.front().vertices[0].position;
}

void SceneDocument::tellSceneChanged()
{
    followMotion();
    emit sceneChanged();
}

void SceneDocument::markSaved()
{
    m_undoStack.setClean();
    m_savedNumber = m_now.number;
    m_savedScene = snapshot();
    m_savedPending = m_now.pending;
    tellModified();
}

void SceneDocument::markUnsaved()
{
    m_undoStack.resetClean();
    m_savedNumber = noNumber;
    m_savedScene.reset();
    tellModified();
}

bool SceneDocument::isModified() const
{
    return m_now.pending != m_savedPending || (m_now.number != m_savedNumber && !hasSavedScene());
}

/// Whether the scene is the saved one, perhaps by another method and the settings it supports.
bool SceneDocument::hasSavedScene() const
{
    if (!m_savedScene)
        return false;
    if (m_savedScene->triangles != scene().triangles)
        return false; // before a large scene is copied
    Scene saved = *m_savedScene;
    saved.method = scene().method;
    if (const Method *method = methodNamed(QString::fromStdString(saved.method)))
        saved.settings = method->adapted(saved.settings);
    return saved == scene();
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
    const Method *method = methodNamed(QString::fromStdString(scene().method));
    return method ? kindPlacedWith(*method) : PrimitiveKind::Triangle;
}

void SceneDocument::setSettings(const ScanSettings &settings)
{
    const Method *method = methodNamed(QString::fromStdString(scene().method));
    const ScanSettings kept = method ? method->adapted(settings) : settings;
    editScene(tr("change settings"), [&](Scene &changed) { changed.settings = kept; });
    tellAdaptation(settings);
}

void SceneDocument::setMethod(const std::string &method)
{
    if (method == scene().method)
        return;
    const QString name = QString::fromStdString(method);
    const Method *chosen = methodNamed(name);
    if (!chosen) {
        emit refused(tr("There is no method “%1”.").arg(name));
        return;
    }
    const ScanSettings asked = scene().settings;
    DocumentState after = m_now; // with its number: only another view of the scene
    Scene &changed = after.changedScene();
    changed.settings = chosen->adapted(asked);
    changed.method = method;
    const auto dropped = kindPlacedWith(*chosen) == placedKind() ? 0 : int(after.pending.size());
    if (dropped > 0)
        after.pending.clear();
    m_undoStack.push(new SceneEdit(*this, tr("change method"), m_now, after, std::nullopt));
    tellAdaptation(asked);
    if (antialiasesLines(*chosen) && antialiasingOf(scene().appearance) == Antialiasing::None)
        emit notice(
            tr("With one sample a pixel, lines have stairs and differ from the truth, which "
               "is the nearest pixels: Effects ▸ exact area makes them even."));
    if (dropped > 0)
        emit verticesDropped(
            tr("%n waiting vertices dropped: “%1” draws another kind of primitive. "
               "Undo brings them back.",
               nullptr, dropped)
                .arg(methodTitle(*chosen)));
}

void SceneDocument::tellAdaptation(const ScanSettings &asked)
{
    const Method *method = methodNamed(QString::fromStdString(scene().method));
    const QString note = method ? adaptationNote(*method, asked) : QString();
    if (!note.isEmpty())
        emit notice(note);
}

void SceneDocument::setSolid(std::size_t index, const Solid &solid, int drag)
{
    if (index < scene().solids.size())
        editScene(
            tr("change solid"), [&](Scene &changed) { changed.solids[index] = solid; },
            Drag{VertexRef(), drag});
}

void SceneDocument::setSolidShown(std::size_t index, bool shown)
{
    if (index < scene().solids.size())
        editScene(shown ? tr("show solid") : tr("hide solid"),
                  [&](Scene &changed) { changed.solids[index].isHidden = !shown; });
}

bool SceneDocument::canMoveSolid(std::size_t index, int places) const
{
    const auto count = std::ptrdiff_t(scene().solids.size());
    const auto from = std::ptrdiff_t(index);
    return from < count && from + places >= 0 && from + places < count;
}

void SceneDocument::moveSolid(std::size_t index, int places)
{
    if (places == 0 || !canMoveSolid(index, places))
        return;
    editScene(tr("change drawing order"), [&](Scene &changed) {
        const Solid moved = changed.solids[index];
        changed.solids.erase(changed.solids.begin() + std::ptrdiff_t(index));
        changed.solids.insert(changed.solids.begin() + std::ptrdiff_t(index) + places, moved);
    });
}

void SceneDocument::deleteSolid(std::size_t index)
{
    if (index < scene().solids.size())
        editScene(tr("delete solid"), [&](Scene &changed) {
            changed.solids.erase(changed.solids.begin() + std::ptrdiff_t(index));
        });
}

} // namespace pixelplumb
