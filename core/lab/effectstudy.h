// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/measure/spread.h"
#include "core/number/jobprogress.h"
#include "core/scan/scansettings.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// What an effect, or a finer form of it, costs and what it mends: one way to draw one scene. Rows
/// of a group draw the same scene and are judged by one truth; the first is what the others are
/// measured by.
struct EffectRow {
    /// "antialiasing", "depth buffer", "perspective", "segments", "neutral effects", "lines,
    /// Bresenham"; "kernel of light": a straight loop of the same effects, and the kernel.
    QString group;
    QString way; ///< "16 samples"
    Arithmetic arithmetic = Arithmetic::Exact;
    std::int64_t pixels = 0; ///< of the picture that are not its background
    std::optional<Spread> perPixel; ///< ns; none where nothing was timed
    std::optional<Spread>
        timesFirst; ///< of the group's first row in the same arithmetic, by rounds
    /// Levels, over pixels and channels, from the exact area, or from the truth of all effects.
    double rms = 0;
    std::int64_t wrongPixels = 0; ///< in other bytes than that
    std::optional<double> distance; ///< of a surface's triangles from it, in the scene's unit
    /// Of a line: the shares of white that its pixels have, together, for each pixel by which it is
    /// longer. 1 is even: a line one pixel wide. 1/√2 is what one pixel a column has at 45°.
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
/// None where the group has no lines.
std::optional<BrightnessRange> brightnessRangeOf(const std::vector<EffectRow> &rows,
                                                 const QString &group);

/// All of them in turn, round by round, by the column scan's plain kernels in exact arithmetic and
/// float32: antialiasing beside the exact area, depth buffers beside exact depths, affine beside
/// perspective, segments of a sphere and a patch, effects that change nothing forced on; lines in
/// every direction by their own methods; and in float32 the kernels of sets of effects, each beside
/// a straight loop. Rounds 0: the errors alone. None where the listener ended it.
std::optional<std::vector<EffectRow>> runEffectStudy(int rounds,
                                                     const ProgressListener &listener = {});

} // namespace pixelplumb
