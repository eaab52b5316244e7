// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/truepicture.h"

#include "core/oracle/effectoracle.h"
#include "core/oracle/oracle.h"
#include "core/oracle/shapeoracle.h"

namespace pixelplumb::oracle {

namespace {

/// Gives every shape its first vertex's colour, except points, which each keep their own.
Primitives inOneColour(Primitives primitives)
{
    for (Shape &shape : primitives.shapes) {
        for (Vertex &vertex : shape.vertices) {
            if (shape.kind != PrimitiveKind::Point)
                vertex.colour = shape.vertices[0].colour;
        }
    }
    return primitives;
}

void drawShapes(const Primitives &primitives, const ScanSettings &settings,
                Antialiasing antialiasing, StrokeTruth strokes, FrameView frame)
{
    const bool isWide = antialiasing != Antialiasing::None || strokes == StrokeTruth::PixelWide;
    if (isWide)
        drawStrokes(primitives, settings, antialiasing, frame);
    for (const Shape &shape : primitives.shapes) {
        if (!isWide || !isStroke(shape))
            draw(shape, settings.rounding, frame);
    }
}

} // namespace

void drawPicture(const Primitives &primitives, const ScanSettings &settings,
                 const EffectPlan *shading, FrameView frame, StrokeTruth strokes)
{
    if (shading) {
        drawEffects(primitives, settings, truthOf(primitives.appearance), frame);
    } else {
        for (const Triangle &triangle : primitives.triangles)
            draw(triangle, {settings, frame}, settings.rounding, frame);
    }
    const EffectTruth what = truthOf(primitives.appearance);
    if (!what.smooth)
        drawShapes(inOneColour(primitives), settings, what.antialiasing, strokes, frame);
    else
        drawShapes(primitives, settings, what.antialiasing, strokes, frame);
}

} // namespace pixelplumb::oracle
