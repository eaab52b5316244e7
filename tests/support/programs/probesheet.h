// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

#include <span>
#include <vector>

namespace pixelplumb {

/// Finds a few scenes that tell the known defects of an assignment's method apart. `conventions`
/// gives the method, which draws triangles or lines, the settings, the frame's origin and pixel
/// centre. From `candidates` random scenes it greedily takes the one that tells most apart, until
/// none tells more.
std::vector<Scene> searchProbes(const Scene &conventions, std::uint64_t seed, int candidates);

/// Defects that draw the same pictures of all scenes.
struct AlikeDefects {
    std::vector<Defect> defects;
    bool equalRight = false; ///< and equal the right ones
};

/// What the scenes cannot tell apart: groups of two or more defects, or one that equals the right
/// pictures. All scenes have one method and the same settings.
struct ProbeResult {
    std::size_t defects = 0; ///< in all
    std::vector<AlikeDefects> alike;

    /// Distinct sets of pictures, including the right one.
    std::size_t distinct() const;
};

ProbeResult probe(std::span<const Scene> scenes);

} // namespace pixelplumb
