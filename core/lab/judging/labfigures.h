// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationcounts.h"
#include "core/measure/spread.h"
#include "core/scene/scene.h"

#include <array>
#include <cstdint>
#include <optional>

namespace pixelplumb {

/// A count out of a total.
struct LabShare {
    std::int64_t count = 0;
    std::int64_t of = 0;

    /// Parts per million; 0 of nothing.
    double perMillion() const { return of == 0 ? 0 : 1e6 * double(count) / double(of); }

    friend bool operator==(const LabShare &, const LabShare &) = default;
};

/// How far missed samples lie from the triangle's boundary, by decades: bin 0 is nearer than 10^-7
/// px, bin k from 10^(k−8) to 10^(k−7) px, the last one farther than 100 px. Ties are not included.
struct MissHistogram {
    static constexpr std::size_t bins = 11;
    std::array<std::int64_t, bins> missing = {}; ///< inside, not painted
    std::array<std::int64_t, bins> extra = {}; ///< outside, painted

    static std::size_t binOf(double distance);
    /// px; 0 for the first bin.
    static double lowerEnd(std::size_t bin);

    friend bool operator==(const MissHistogram &, const MissHistogram &) = default;
};

/// Errors in levels, before these become bytes, over the pixels that both the contender and the
/// truth paint and whose level is a number.
struct LevelErrors {
    std::int64_t samples = 0; ///< levels: three a pixel
    double largest = 0;
    double rms = 0;
    double p999 = 0; ///< 99.9 % of the magnitudes do not exceed it

    friend bool operator==(const LevelErrors &, const LevelErrors &) = default;
};

/// What a contender got wrong in a family, judged triangle by triangle by the oracle under the rule
/// that the contender claims. A figure that was not measured is empty.
struct AccuracyFigures {
    std::int64_t triangles = 0; ///< drawn one by one
    std::int64_t pixels = 0; ///< of the truth
    std::int64_t missing = 0; ///< not ties
    std::int64_t extra = 0;
    std::int64_t tiesMissing = 0; ///< samples exactly on the boundary
    std::int64_t tiesExtra = 0;
    std::int64_t wrongTriangles = 0; ///< with at least one of these
    MissHistogram misses;
    double farthestMissing = 0; ///< px
    double farthestExtra = 0; ///< px
    std::int64_t wrongBytes = 0; ///< pixels that both paint, in different bytes
    int largestByteError = 0; ///< levels

    std::optional<LevelErrors> levels; ///< before rounding; of a part of the pixels
    std::optional<LabShare> notANumber; ///< pixels with a NaN level
    std::optional<LabShare> infinite;
    std::optional<LabShare> clamped; ///< pixels with a level outside 0 … 255

    std::optional<LabShare> gaps; ///< in a mesh: samples that no triangle paints
    std::optional<LabShare> doubles; ///< in a mesh: samples painted more than once
    /// For a moving sliver: pixels that come and go between two frames, beyond those of the truth;
    /// negative if fewer do.
    std::optional<std::int64_t> flicker;
    std::optional<std::int64_t> trueToggles;
    std::optional<LabShare> orderFailures; ///< triangles whose vertices' order changes the picture
    std::optional<LabShare> translationFailures; ///< triangles whose picture a move changes

    std::int64_t wrongCoverage() const { return missing + extra + tiesMissing + tiesExtra; }
    /// Wrong in any way.
    std::int64_t wrongPixels() const { return wrongCoverage() + wrongBytes; }
    /// Per million pixels of the truth.
    double wrongPerMillion() const { return LabShare{wrongPixels(), pixels}.perMillion(); }

    friend bool operator==(const AccuracyFigures &, const AccuracyFigures &) = default;
};

/// What drawing a family costs. All contenders of a family draw the same triangles.
struct CostFigures {
    Spread perDraw; ///< ns of processor time
    int rounds = 0;
    std::optional<Spread> straight; ///< ns per draw of the straight loop, in the same rounds
    std::optional<Spread> timesStraight; ///< each round's time over that of the straight loop
    std::optional<OperationCounts> operations; ///< of some of the triangles

    friend bool operator==(const CostFigures &, const CostFigures &) = default;
};

/// The first pixel that a contender gets wrong, in its drawing order, as a scene that Compare can
/// open.
struct LabMiss {
    Scene scene; ///< the triangle alone, with the method, the arithmetic and the rule
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend bool operator==(const LabMiss &, const LabMiss &) = default;
};

} // namespace pixelplumb
