// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/differencemap.h"
#include "core/scene/scene.h"

#include <QObject>

#include <memory>

namespace pixelplumb {

/// What a person switches by hand to see what an effect costs or changes. Of the picture, not of
/// the document: nothing of it is saved or undone.
class EffectSwitches : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const EffectForcing &forced() const { return m_forced; }
    void force(Effect effect, Forcing forcing);
    /// All as called for.
    void reset();

    /// The scene as it is drawn: itself where nothing is forced.
    std::shared_ptr<const Scene> applied(const std::shared_ptr<const Scene> &scene) const;

    /// What forcing changes of the scene's picture; null while that is not known, and while nothing
    /// is forced.
    const std::shared_ptr<const DifferenceMap> &changes() const { return m_changes; }
    void setChanges(std::shared_ptr<const DifferenceMap> changes);

signals:
    void changed();
    void changesFound();

private:
    EffectForcing m_forced;
    std::shared_ptr<const DifferenceMap> m_changes;
};

} // namespace pixelplumb
