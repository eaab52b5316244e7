// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/truepicture.h"

#include "core/oracle/effectoracle.h"
#include "core/oracle/oracle.h"
#include "core/oracle/shapeoracle.h"

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
    for (const Shape &shape : primitives.shapes)
        draw(shape, settings.rounding, frame);
}

} // namespace pixelplumb::oracle
