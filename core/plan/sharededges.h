// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/plan/depthwitness.h"
#include "core/plan/framereach.h"

#include <cstdint>
#include <span>

namespace pixelplumb {

/// How many samples of the frame lie on edges shared by two triangles: the closed rule gives them
/// to both, and blending then shows them twice.
struct SharedSamples {
    std::int64_t samples = 0;
    bool isExact = true; ///< else an upper bound: ends of edges are counted more than once
    SamplePlace first; ///< the pixel of one of them, if any
};

/// For edges with both ends in common and at least one blended triangle. `others` are not blended.
SharedSamples sharedSamplesOf(std::span<const Triangle *const> blended,
                              std::span<const Triangle *const> others, const SampledFrame &where);

} // namespace pixelplumb
