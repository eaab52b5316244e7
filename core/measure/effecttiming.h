// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/effect.h"
#include "core/measure/scenetiming.h"
#include "core/runs/differencemap.h"
#include "core/runs/scenerun.h"

namespace pixelplumb {

/// What an effect costs in a scene, and what it changes: the scene is drawn with it forced on and
/// forced off, all other effects as called for.
struct EffectCost {
    Spread on, off; ///< ns a draw
    Spread ratio; ///< on / off, round by round
    std::int64_t changed = 0; ///< pixels that differ between the two pictures
    /// With it on: depths read and written, divisions by 1/w, texels read, normals made unit
    /// length, blends, samples; none for smooth colour, which has only its increments.
    std::optional<std::int64_t> operations;
};

struct EffectTiming {
    /// None if on and off draw the same (there is nothing to light, nothing to read, no border),
    /// and for what the method cannot do.
    PerEffect<std::optional<EffectCost>> costs;
    std::int64_t pixels = 0; ///< that the scene's picture writes
    int rounds = 0;

    /// Its cost per written pixel, ns: how much longer drawing takes with it.
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

/// Uses the plain kernels of the scene's method, in turn and round by round. Nothing if it was
/// ended. The method must be able to draw the scene (objectionTo).
std::optional<EffectTiming> timeEffects(const Scene &scene, const TimingOptions &options);

/// The pixels whose bytes the forced effects of a run's scene change from its picture as called
/// for: all of them Difference::Colour.
DifferenceMap changesByForcing(const SceneRun &run);

} // namespace pixelplumb
