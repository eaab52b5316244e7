// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <algorithm>

/// The primitives of a scene in the order of its file, the hidden ones in their places.
namespace pixelplumb {

/// Where the hidden shapes begin.
inline std::size_t hiddenTriangleCount(const HiddenPrimitives &hidden)
{
    return std::size_t(std::ranges::count_if(hidden, &HiddenPrimitive::isTriangle));
}

/// The hidden ones of [next, end) among so many drawn ones.
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

/// Calls drawn(index, attributes), null where the triangle has none, and hidden(index among all
/// hidden ones).
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

/// Calls drawn(index) and hidden(index among all hidden ones).
template <class Drawn, class Hidden>
void visitShapes(const Scene &scene, const Drawn &drawn, const Hidden &hidden)
{
    visitInOrder(scene.shapes.size(), scene.hidden, hiddenTriangleCount(scene.hidden),
                 scene.hidden.size(), drawn, hidden);
}

} // namespace pixelplumb
