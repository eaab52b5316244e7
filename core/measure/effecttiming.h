// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/effect.h"
#include "core/measure/scenetiming.h"
#include "core/runs/differencemap.h"

namespace pixelplumb {

/// What an effect costs in a scene, and what it changes: the scene is drawn with it forced on and
/// forced off, all others as called for.
struct EffectCost {
    Spread on, off; ///< ns a draw
    Spread ratio; ///< on / off, round by round
    std::int64_t changed = 0; ///< pixels that differ between the two pictures
    /// With it on: depths read and written, divisions by 1/w, texels read, normals made unit
    /// length, blends, samples; none of smooth colour, which has nothing but its increments.
    std::optional<std::int64_t> operations;
};

struct EffectTiming {
    /// None where on and off draw the same (there is nothing to light, nothing to read, no border),
    /// and of what the method cannot do.
    PerEffect<std::optional<EffectCost>> costs;
    std::int64_t pixels = 0; ///< that the scene's picture has written
    int rounds = 0;

    /// What it costs for each written pixel, ns: how much longer it takes with it.
    double perPixel(const EffectCost &cost) const
    {
        return (cost.on.median - cost.off.median) / double(std::max<std::int64_t>(pixels, 1));
    }
    std::optional<double> operationsPerPixel(const EffectCost &cost) const
    {
        if (!cost.operations)
            return std::nullopt;
        return double(*cost.operations) / double(std::max<std::int64_t>(pixels, 1));
    }
};

/// By the plain kernels of the scene's method, in turn and round by round. Nothing when it was
/// ended. The method must be able to draw the scene (objectionTo).
std::optional<EffectTiming> timeEffects(const Scene &scene, const TimingOptions &options);

/// The pixels whose bytes what is forced in the scene changes of its picture as called for: all of
/// them Difference::Colour.
DifferenceMap changesByForcing(const Scene &scene);

} // namespace pixelplumb
