// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cameratransform.h"

#include <cstddef>
#include <vector>

namespace pixelplumb {

/// A face's vertex with everything that is interpolated.
template <class Number>
struct ClipVertex {
    ClipPoint<Number> clip;
    SpaceVector<Number> place; ///< in the scene's space
    SpaceVector<Number> normal;
    std::array<Number, 2> texture = {};
    std::array<Number, 4> levels = {}; ///< red, green, blue, alpha: 0 … 255

    /// At or beyond the near plane.
    bool isInside() const { return clip.z >= 0; }
    bool isOnPlane() const { return clip.z == 0; }
};

/// A corner of the clipped polygon: a kept vertex, or the cut of an edge.
template <class Number>
struct ClippedCorner {
    ClipVertex<Number> vertex;
    std::size_t inside = 0; ///< the vertex, or the kept end of the cut edge
    std::size_t outside = 0; ///< the same vertex, or the other end of the edge
    Number t = Number(0); ///< from the inside end to the outside one

    bool isCut() const { return inside != outside; }
};

/// The edge's intersection with the near plane. It is computed from the inside end whichever way
/// the edge runs, so that both faces at an edge get the same point; z and w are those of the plane.
template <class Number>
ClippedCorner<Number> cutEdge(const std::vector<ClipVertex<Number>> &polygon, std::size_t inside,
                              std::size_t outside, const Number &wAtNear)
{
    const ClipVertex<Number> &a = polygon[inside];
    const ClipVertex<Number> &b = polygon[outside];
    const Number t = a.clip.z / (a.clip.z - b.clip.z);
    ClippedCorner<Number> corner{{}, inside, outside, t};
    ClipVertex<Number> &cut = corner.vertex;
    cut.clip = {between(a.clip.x, b.clip.x, t), between(a.clip.y, b.clip.y, t), Number(0), wAtNear};
    cut.place = between(a.place, b.place, t);
    cut.normal = between(a.normal, b.normal, t);
    for (std::size_t i = 0; i < cut.texture.size(); ++i)
        cut.texture[i] = between(a.texture[i], b.texture[i], t);
    for (std::size_t i = 0; i < cut.levels.size(); ++i)
        cut.levels[i] = between(a.levels[i], b.levels[i], t);
    return corner;
}

/// The part of a convex polygon at or beyond the near plane, edge by edge [Sutherland 1974]. Only
/// this plane is needed: beyond it w > 0, and the frame's rows and columns clip the rest. A vertex
/// on the plane is itself a corner: its edges are not cut there again.
template <class Number>
void clipAtNear(const std::vector<ClipVertex<Number>> &polygon, const Number &wAtNear,
                std::vector<ClippedCorner<Number>> &clipped)
{
    clipped.clear();
    for (std::size_t from = 0; from < polygon.size(); ++from) {
        const std::size_t to = (from + 1) % polygon.size();
        const bool staysInside = polygon[from].isInside();
        const bool endsInside = polygon[to].isInside();
        if (staysInside)
            clipped.push_back({polygon[from], from, from, Number(0)});
        const std::size_t inside = staysInside ? from : to;
        if (staysInside != endsInside && !polygon[inside].isOnPlane())
            clipped.push_back(cutEdge(polygon, inside, staysInside ? to : from, wAtNear));
    }
}

} // namespace pixelplumb
