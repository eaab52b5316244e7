// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/requirements.h"
#include "core/methods/method.h"
#include "widgets/look/methodtitle.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/sceneedit.h"

#include <algorithm>

/// The method of a document's scene, and what depends on it: the settings, and the kind of
/// primitive that a person places.
namespace pixelplumb {

namespace {

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

PrimitiveKind SceneDocument::placedKind() const
{
    const Method *method = methodNamed(QString::fromStdString(m_scene.method));
    return method ? kindPlacedWith(*method) : PrimitiveKind::Triangle;
}

void SceneDocument::setSettings(const ScanSettings &settings)
{
    const Method *method = methodNamed(QString::fromStdString(m_scene.method));
    const ScanSettings kept = method ? method->adapted(settings) : settings;
    if (kept != m_scene.settings) {
        ScenePiece after = pieceAtEnd();
        after.settings = kept;
        edit(tr("change settings"), pieceAtEnd(), after);
    }
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
    after.settings = chosen->adapted(asked);
    after.method = method;
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

} // namespace pixelplumb
