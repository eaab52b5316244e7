// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/edgepixels.h"
#include "core/effects/framereach.h"
#include "core/effects/planeorder.h"
#include "core/geometry/appearance.h"

#include <optional>

namespace pixelplumb {

/// A sample of a pixel, sample coordinates.
struct SamplePlace {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend bool operator==(const SamplePlace &, const SamplePlace &) = default;
};

/// What was found of two triangles, looking at what is drawn of them.
struct WitnessSearch {
    /// A pixel at a sample of which both are drawn and the later one is farther, by exact numbers
    /// and by what the depth buffer keeps of them. Where areas are covered depths are those at the
    /// pixel's centre, also beside a triangle.
    std::optional<SamplePlace> found;
    bool wasComplete = false; ///< nothing of the window was left out
    int steps = 0; ///< rows and pixels that were looked at
};

/// Where two triangles are looked at, and how closely.
struct WitnessWindow {
    SampleBox pixels;
    int mostSteps = 0; ///< after which the search ends
};

/// Looks at the samples of a window row by row. `edges` are the pixels that have 4 or 16 samples;
/// null where none have.
WitnessSearch searchWitness(const DepthTriangle &earlier, const DepthTriangle &later,
                            const SampledFrame &where, const EdgePixels *edges, DepthFormat format,
                            const WitnessWindow &window);

} // namespace pixelplumb
