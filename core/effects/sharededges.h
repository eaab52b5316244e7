// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/depthwitness.h"
#include "core/effects/framereach.h"
#include "core/geometry/triangle.h"

#include <cstdint>
#include <span>

namespace pixelplumb {

/// How many samples of the frame lie on edges that two triangles share: the closed rule gives them
/// to both, and blending then shows them twice.
struct SharedSamples {
    std::int64_t samples = 0;
    bool isExact = true; ///< otherwise at most so many: ends of edges are counted more than once
    SamplePlace first; ///< the pixel of one of them, where there are any
};

/// Of edges that have both ends in common, and at least one of whose triangles is blended. `others`
/// are not.
SharedSamples sharedSamplesOf(std::span<const Triangle *const> blended,
                              std::span<const Triangle *const> others, const SampledFrame &where);

} // namespace pixelplumb
