// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/measure/spread.h"
#include "core/number/jobprogress.h"
#include "core/scan/scansettings.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// What an effect, or a finer form of it, costs and improves: one way to draw one scene. Rows of a
/// group draw the same scene and are judged by one truth; the others are compared with the first.
struct EffectRow {
    /// "antialiasing", "depth buffer", "perspective", "segments", "neutral effects", "lines,
    /// Bresenham"; "kernel of light": a straight loop of the same effects, and the kernel.
    QString group;
    QString way; ///< "16 samples"
    Arithmetic arithmetic = Arithmetic::Exact;
    std::int64_t pixels = 0; ///< of the picture, without its background
    std::optional<Spread> perPixel; ///< ns; none where nothing was timed
    std::optional<Spread>
        timesFirst; ///< relative to the group's first row in the same arithmetic, by rounds
    /// RMS error in levels, over pixels and channels, from the exact area or the truth of all
    /// effects.
    double rms = 0;
    std::int64_t wrongPixels = 0; ///< whose bytes differ from that
    std::optional<double> distance; ///< between a surface and its triangles, in the scene's unit
    /// For a line: the sum of its pixels' shares of white, per pixel of its length. 1 is even: a
    /// line one pixel wide. 1/√2 is what one pixel per column gives at 45°.
    std::optional<double> brightness;

    /// Whether it is a kernel that takes more than mostTimesLoop as long as its straight loop.
    bool isTooSlow() const;

    friend bool operator==(const EffectRow &, const EffectRow &) = default;
};

inline constexpr double mostTimesLoop = 1.3;

/// The least and the greatest brightness of a group's lines, whatever their direction.
struct BrightnessRange {
    double least = 0;
    double greatest = 0;
};
/// None if the group has no lines.
std::optional<BrightnessRange> brightnessRangeOf(const std::vector<EffectRow> &rows,
                                                 const QString &group);

/// Measures everything in turn, round by round, by the column scan's plain kernels in exact
/// arithmetic and float32: antialiasing against the exact area, depth buffers against exact depths,
/// affine against perspective, segments of a sphere and a patch, effects forced on that change
/// nothing; lines in every direction by their own methods; and in float32 the kernels of sets of
/// effects, each against a straight loop. Rounds 0: only the errors. None if the listener ended it.
std::optional<std::vector<EffectRow>> runEffectStudy(int rounds,
                                                     const ProgressListener &listener = {});

} // namespace pixelplumb
