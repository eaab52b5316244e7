// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/plan/framereach.h"
#include "core/plan/planeorder.h"
#include "core/shade/edgepixels.h"

#include <optional>

namespace pixelplumb {

/// A sample of a pixel, sample coordinates.
struct SamplePlace {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend bool operator==(const SamplePlace &, const SamplePlace &) = default;
};

/// The result of searching two triangles, as they are drawn, for a witness.
struct WitnessSearch {
    /// A pixel with a sample at which both are drawn and the later one is farther, both in exact
    /// numbers and as the depth buffer stores them. With area antialiasing depths are those at the
    /// pixel's centre, even outside a triangle.
    std::optional<SamplePlace> found;
    bool wasComplete = false; ///< the whole window was searched
    int steps = 0; ///< rows and pixels examined
};

/// Where two triangles are searched, and how thoroughly.
struct WitnessWindow {
    SampleBox pixels;
    int mostSteps = 0; ///< the search ends after these
};

/// Searches the samples of a window row by row. `edges` are the pixels that have 4 or 16 samples;
/// null where none have.
WitnessSearch searchWitness(const DepthTriangle &earlier, const DepthTriangle &later,
                            const SampledFrame &where, const EdgePixels *edges, DepthFormat format,
                            const WitnessWindow &window);

} // namespace pixelplumb
