// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/depthtiles.h"
#include "core/plan/framereach.h"

#include <algorithm>

namespace pixelplumb {

/// The triangles that the depth question is about, in drawing order, each with its box in the frame
/// and its depths: those that reach the frame, including under the closed rule the segments of
/// those without area.
struct DepthCandidates {
    std::int32_t width = 0, height = 0; ///< of the frame that holds the boxes, lattice units
    std::vector<DepthBox> boxes;
    std::vector<std::uint32_t> triangles; ///< indices into the primitives
    std::vector<std::array<Attribute, 3>>
        z; ///< of the vertices; a segment's middle one has an end's depth
    std::vector<std::array<Attribute, 3>> w; ///< of the vertices, as in DepthTriangle

    /// By how much depths at the centres of its pixels may exceed those of the vertices: with area
    /// antialiasing such a centre may lie half a pixel outside, along either axis or both.
    std::vector<Attribute> excess;

    /// Bounds for the depths that are compared.
    Attribute nearest(std::size_t i) const { return std::ranges::min(z[i]) - excess[i]; }
    Attribute farthest(std::size_t i) const { return std::ranges::max(z[i]) + excess[i]; }
};

/// Where pixels have more than one sample, the frame includes half a pixel around it.
DepthCandidates depthCandidatesOf(const Primitives &primitives, const SampledFrame &where);

/// Whether all vertices of all triangles have one depth; triangles without attributes have depth 0.
bool haveOneDepth(const Primitives &primitives);

/// Whether each is at least as near at every vertex as all before it.
bool areInOrder(const DepthCandidates &candidates);

} // namespace pixelplumb
