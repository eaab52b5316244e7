// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/methods/run.h"

#include <span>

namespace pixelplumb {

/// What a kernel of effects is measured against: one set of effects as one function, by the column
/// scan in float32 under the half-open rule, without clipping, choices, observers or work for
/// absent effects. On its own scene its pictures are the kernel's, bit for bit.
struct EffectLoop {
    const char *name; ///< "depth, 24 bits"
    /// For triangles with area inside the frame, all with attributes.
    void (*draw)(const Primitives &primitives, FrameView frame);
    Primitives (*makeScene)(); ///< sample coordinates, in a frame of effectLoopSide px
};

inline constexpr std::int32_t effectLoopSide = 256;

std::span<const EffectLoop> effectLoops();

/// The scene of a loop as its kernel receives it.
struct EffectLoopScene {
    FrameSpec frame;
    Run run; ///< of the column scan in float32, under the rule of half-open columns

    explicit EffectLoopScene(const EffectLoop &loop);
};

} // namespace pixelplumb
