// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/differencemap.h"
#include "core/scene/scene.h"

#include <QObject>

#include <memory>

namespace pixelplumb {

/// What a person switches by hand to see what an effect costs or changes. It belongs to the
/// picture, not to the document: it is neither saved nor undone.
class EffectSwitches : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const EffectForcing &forced() const { return m_forced; }
    void force(Effect effect, Forcing forcing);
    /// Sets all effects back to what the scene calls for.
    void reset();

    /// The scene as it is drawn; the scene itself where nothing is forced.
    std::shared_ptr<const Scene> applied(const std::shared_ptr<const Scene> &scene) const;

    /// What forcing changes in the scene's picture; null while that is unknown, and while nothing
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
