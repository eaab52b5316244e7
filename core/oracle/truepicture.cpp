// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/truepicture.h"

#include "core/oracle/effectoracle.h"
#include "core/oracle/oracle.h"
#include "core/oracle/shapeoracle.h"
#include "core/oracle/strokeoracle.h"

namespace pixelplumb::oracle {

void drawPicture(const Primitives &primitives, const ScanSettings &settings,
                 const std::optional<EffectPlan> &plan, FrameView frame)
{
    if (plan) {
        drawEffects(primitives, settings, truthOf(primitives.appearance), frame);
    } else {
        for (const Triangle &triangle : primitives.triangles)
            draw(triangle, {settings, frame}, settings.rounding, frame);
    }
    const Antialiasing antialiasing = truthOf(primitives.appearance).antialiasing;
    const bool hasShares = antialiasing != Antialiasing::None;
    if (hasShares)
        drawStrokes(primitives, settings, antialiasing, frame);
    for (const Shape &shape : primitives.shapes) {
        if (!hasShares || !isStroke(shape))
            draw(shape, settings.rounding, frame);
    }
}

} // namespace pixelplumb::oracle
