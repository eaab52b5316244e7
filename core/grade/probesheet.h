// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"
#include "core/number/jobprogress.h"

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// The few scenes that tell the known defects of an assignment's method apart. What the assignment
/// lays down is a scene's: its method, which draws triangles or lines, its settings, its frame's
/// origin and pixel centre. Greedily of so many random scenes, each time the one that tells most
/// apart, until none tells more. None where the listener, who hears how many are drawn, ended it.
std::optional<std::vector<Scene>> searchProbes(const Scene &conventions, std::uint64_t seed,
                                               std::int64_t candidates,
                                               const ProgressListener &listener = {});

/// Defects that draw the same pictures of all scenes.
struct AlikeDefects {
    std::vector<Defect> defects;
    bool equalRight = false; ///< and the right ones, too
};

/// What scenes leave together: groups of two or more, or one that equals the right pictures. All
/// scenes have one method and the same settings.
struct ProbeResult {
    std::size_t defects = 0; ///< in all
    std::vector<AlikeDefects> alike;

    /// Pictures that are told apart, the right ones among them.
    std::size_t distinct() const;
};

ProbeResult probe(std::span<const Scene> scenes);

} // namespace pixelplumb
