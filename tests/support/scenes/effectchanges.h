// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/framespec.h"
#include "tests/support/scenes/plannedtriangles.h"

#include <functional>

/// A scene that needs no effect, and changes to it.
namespace pixelplumb {

using Change = std::function<void(Primitives &)>;

inline const FrameSpec &frameSpec()
{
    static const FrameSpec spec = frameOf(32, 24);
    return spec;
}

inline FrameView frameView()
{
    static const FrameBuffer frame(frameSpec());
    return frame.view();
}

/// Two white triangles next to each other in the frame of 32 × 24 pixels.
inline Primitives plain()
{
    Primitives primitives;
    primitives.triangles
        = {triangleAt({{{2, 2}, {10, 2}, {2, 10}}}), triangleAt({{{12, 2}, {20, 2}, {12, 10}}})};
    return primitives;
}

inline Primitives changed(const Change &change)
{
    Primitives primitives = plain();
    change(primitives);
    return primitives;
}

/// Moves the second triangle onto the first: 10 px to the left and 3 px up.
inline void overlap(Primitives &primitives)
{
    for (Vertex &vertex : primitives.triangles[1].vertices)
        vertex.position
            = {vertex.position.x - 10 * unitsPerPixel, vertex.position.y + 3 * unitsPerPixel};
}

/// A line from red to green.
inline Shape smoothLine()
{
    Shape line;
    line.vertices
        = {{latticePixel(2, 2), Colour{{255, 0, 0}}}, {latticePixel(40, 2), Colour{{0, 255, 0}}}};
    return line;
}

inline void setW(Primitives &primitives, std::size_t triangle, Attribute w)
{
    attributesAt(primitives, triangle).vertices[2].w = w;
}

inline void setColour(Primitives &primitives, std::size_t triangle)
{
    primitives.triangles[triangle].vertices[1].colour.channels[2] = 254;
}

inline PerEffect<EffectVerdict> verdictsOf(const Primitives &primitives, ScanSettings settings = {})
{
    return requirementsOf(primitives, settings, frameView());
}

inline EffectPlan planOf(const Primitives &primitives)
{
    return planFor(primitives, ScanSettings{}, frameView());
}

} // namespace pixelplumb
