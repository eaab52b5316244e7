// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/shadedchoice.h"
#include "core/number/jobprogress.h"

#include <array>

namespace pixelplumb {

/// How often the work of effects was done, and what memory their buffers took.
struct EffectTally {
    std::array<std::int64_t, effectWorkCount> done = {};
    std::size_t depthBytes = 0;

    std::int64_t operator[](EffectWork work) const { return done[std::size_t(work)]; }
    friend bool operator==(const EffectTally &, const EffectTally &) = default;
};

/// Draws the triangles as the plan says, each batch by the kernel that was compiled for it; in
/// float64, in 256 bits and in pixels that a triangle covers in part by one that asks at each
/// sample. The settings' arithmetic is one that the method shades in.
void drawShaded(ShadedMethod method, const Primitives &primitives, const ScanSettings &settings,
                FrameView frame, const EffectPlan &plan);

/// The same; false where the listener, who hears before each triangle how many are drawn, ended it.
/// With 4 or 16 samples a triangle counts once more for each.
bool drawShaded(ShadedMethod method, const Primitives &primitives, const ScanSettings &settings,
                FrameView frame, const EffectPlan &plan, const ProgressListener &listener);

/// The same picture, counting, by the kernel that takes all its effects when it runs: what the
/// others are tested against.
EffectTally countShaded(ShadedMethod method, const Primitives &primitives,
                        const ScanSettings &settings, FrameView frame, const EffectPlan &plan);

} // namespace pixelplumb
