// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <algorithm>

/// Visits a scene's primitives in the order of its file, the hidden ones in their places.
namespace pixelplumb {

/// Also the index of the first hidden shape.
inline std::size_t hiddenTriangleCount(const HiddenPrimitives &hidden)
{
    return std::size_t(std::ranges::count_if(hidden, &HiddenPrimitive::isTriangle));
}

/// Visits `count` drawn primitives and, in their places, the hidden ones of [next, end).
template <class Drawn, class Hidden>
void visitInOrder(std::size_t count, const HiddenPrimitives &all, std::size_t next, std::size_t end,
                  const Drawn &drawn, const Hidden &hidden)
{
    for (std::size_t index = 0; index <= count; ++index) {
        for (; next < end && all[next].place <= index; ++next)
            hidden(next);
        if (index < count)
            drawn(index);
    }
}

/// Calls drawn(index, attributes), with null for a triangle without attributes, and hidden(index
/// among all hidden primitives).
template <class Drawn, class Hidden>
void visitTriangles(const Scene &scene, const Drawn &drawn, const Hidden &hidden)
{
    auto next = scene.attributes.begin();
    const auto drawnNext = [&](std::size_t index) {
        const bool isNext = next != scene.attributes.end() && next->triangle == index;
        drawn(index, isNext ? &*next++ : nullptr);
    };
    visitInOrder(scene.triangles.size(), scene.hidden, 0, hiddenTriangleCount(scene.hidden),
                 drawnNext, hidden);
}

/// Calls drawn(index) and hidden(index among all hidden primitives).
template <class Drawn, class Hidden>
void visitShapes(const Scene &scene, const Drawn &drawn, const Hidden &hidden)
{
    visitInOrder(scene.shapes.size(), scene.hidden, hiddenTriangleCount(scene.hidden),
                 scene.hidden.size(), drawn, hidden);
}

} // namespace pixelplumb
