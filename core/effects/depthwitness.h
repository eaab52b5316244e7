// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/planeorder.h"
#include "core/geometry/appearance.h"
#include "core/scan/boundaryrule.h"
#include "core/scan/edgeteststate.h"

#include <optional>

namespace pixelplumb {

/// A sample of a pixel, sample coordinates.
struct SamplePlace {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend bool operator==(const SamplePlace &, const SamplePlace &) = default;
};

/// What was found of two triangles, looking at samples.
struct WitnessSearch {
    /// A sample that both cover and at which the later one is farther, by exact numbers and by what
    /// the depth buffer keeps of them.
    std::optional<SamplePlace> found;
    bool wasComplete = false; ///< every sample of the window was looked at
    int samples = 0; ///< that were looked at
};

/// Looks at the samples of a window; of a large one at some, evenly spread.
WitnessSearch searchWitness(const DepthTriangle &earlier, const DepthTriangle &later,
                            const SampleBox &window, const BoundaryRule &rule, DepthFormat format);

} // namespace pixelplumb
