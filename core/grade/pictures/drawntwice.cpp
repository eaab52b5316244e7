// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/drawntwice.h"

#include "core/runs/scenerun.h"

namespace pixelplumb {

std::int64_t drawnTwice(const Scene &scene, const Picture &found)
{
    Scene closed = scene;
    closed.settings.fillRule = FillRule::Closed;
    const bool canBeTold = found.hasColours && closed != scene && mayCallForEffects(scene)
        && planOf(SceneRun(scene)).runs(Effect::Blending) && objectionTo(closed).isEmpty();
    if (!canBeTold)
        return 0;
    const Picture once = pictureOf(scene);
    const Picture twice = pictureOf(closed);
    std::int64_t count = 0;
    for (std::size_t i = 0; i < once.size(); ++i) {
        const bool isCovered = once.covered[i] != 0 && twice.covered[i] != 0;
        if (isCovered && once.colours[i] != twice.colours[i]
            && found.colours[i] == twice.colours[i])
            ++count;
    }
    return count;
}

} // namespace pixelplumb
