// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/effectswitches.h"

#include <utility>

namespace pixelplumb {

void EffectSwitches::force(Effect effect, Forcing forcing)
{
    if (m_forced[effect] == forcing)
        return;
    m_forced[effect] = forcing;
    emit changed();
}

void EffectSwitches::reset()
{
    if (m_forced == EffectForcing{})
        return;
    m_forced = {};
    emit changed();
}

std::shared_ptr<const Scene> EffectSwitches::applied(
    const std::shared_ptr<const Scene> &scene) const
{
    if (m_forced == scene->appearance.forced)
        return scene;
    const auto drawn = std::make_shared<Scene>(*scene);
    drawn->appearance.forced = m_forced;
    return drawn;
}

void EffectSwitches::setChanges(std::shared_ptr<const DifferenceMap> changes)
{
    if (m_changes == changes)
        return;
    m_changes = std::move(changes);
    emit changesFound();
}

} // namespace pixelplumb
