// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/fastscan.h"
#include "core/measure/spread.h"
#include "core/number/jobprogress.h"
#include "core/scene/scene.h"

#include <optional>

namespace pixelplumb {

struct TimingOptions {
    int rounds = 11;
    double sampleNanoseconds = 2e6; ///< a sample draws as often as fills this
    double longestDraw = 100e6; ///< ns; if a scene takes longer, only its first triangles are drawn
    ProgressListener progress; ///< receives how many of all samples are taken
};

/// One way of drawing, and how long it took.
struct DrawTime {
    Spread perDraw; ///< ns
    int threads = 1;

    double perPixel(std::uint64_t pixels) const { return perDraw.median / double(pixels); }
    double perTriangle(std::size_t triangles) const { return perDraw.median / double(triangles); }
};

/// How long drawing a scene took by the plain and by the fast kernels, and how long memory takes.
struct SceneTiming {
    /// The scene's, with the half-open rule in place of one that the column scan does not support.
    ScanSettings settings;
    std::size_t triangles = 0; ///< drawn: the scene's first ones
    std::uint64_t pixels = 0; ///< that they cover, counted each time
    int rounds = 0;
    DrawTime plain;
    DrawTime fast; ///< on one thread
    std::optional<DrawTime> parallel; ///< on all of the machine's, if starting them pays off
    DrawTime memory; ///< memset over as many pixels
    bool sameBytes = false; ///< the plain and the fast picture
    FastReport report; ///< of the fast kernels on one thread

    /// The memory's time as a share of the draw's, 0 … 1 but for noise.
    double shareOfMemory(const DrawTime &time) const
    {
        return memory.perDraw.median / time.perDraw.median;
    }
};

/// Draws the scene's triangles by each kernel in turn, round by round: what slows the machine for a
/// while slows all of them. Nothing if it was ended. Without triangles, or if none covers a pixel,
/// nothing is timed and `rounds` is 0.
std::optional<SceneTiming> timeScene(const Scene &scene, const TimingOptions &options);

} // namespace pixelplumb
