// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/depthtiles.h"
#include "core/effects/framereach.h"

#include <algorithm>

namespace pixelplumb {

/// The triangles that depth's question is asked of: those that reach the frame, and under the
/// closed rule the segments of those without area, in drawing order, each with its box in the frame
/// and its depths.
struct DepthCandidates {
    std::int32_t width = 0, height = 0; ///< of the frame that boxes lie in, lattice units
    std::vector<DepthBox> boxes;
    std::vector<std::uint32_t> triangles; ///< indices in the primitives
    std::vector<std::array<Attribute, 3>>
        z; ///< of the vertices; of a segment's middle one, an end's
    std::vector<std::array<Attribute, 3>> w; ///< of the vertices, as DepthTriangle has them

    Attribute nearest(std::size_t i) const { return std::ranges::min(z[i]); }
    Attribute farthest(std::size_t i) const { return std::ranges::max(z[i]); }
    bool isFlat(std::size_t i) const { return nearest(i) == farthest(i); }
};

/// Where pixels have more than one sample, half a pixel around the frame belongs to it.
DepthCandidates depthCandidatesOf(const Primitives &primitives, const SampledFrame &where);

/// All vertices of all triangles; triangles without attributes have depth 0.
bool haveOneDepth(const Primitives &primitives);

/// Each is nearer at every vertex than all before it, or as near.
bool areInOrder(const DepthCandidates &candidates);

} // namespace pixelplumb
