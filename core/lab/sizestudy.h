// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/labcontender.h"
#include "core/measure/spread.h"
#include "core/number/jobprogress.h"

namespace pixelplumb {

/// What grows while all else stays.
enum class SizeAxis : std::uint8_t {
    Width, ///< px, of one triangle of constant height
    Area, ///< px, of one triangle of constant shape
    Triangles, ///< in number, of constant size
};
inline constexpr std::array allSizeAxes = {SizeAxis::Width, SizeAxis::Area, SizeAxis::Triangles};
QString nameOf(SizeAxis axis); ///< "width", "area", "triangles"

struct SizePoint {
    double size = 0; ///< along the axis
    Spread perDraw; ///< ns

    friend bool operator==(const SizePoint &, const SizePoint &) = default;
};

/// How a contender's time grows: t ~ size^exponent.
struct SizeCurve {
    QString contender;
    SizeAxis axis = SizeAxis::Width;
    std::vector<SizePoint> points;
    std::optional<double> exponent; ///< of the larger half of the sizes; none of fewer than two

    friend bool operator==(const SizeCurve &, const SizeCurve &) = default;
};

/// Those whose growth is worth a curve: the column scan in every arithmetic, its fast kernel, and
/// the walk over rows.
std::vector<LabContender> growingContenders();

/// The slope of the logarithms by least squares; none of fewer than two points.
std::optional<double> fittedExponent(std::span<const SizePoint> points);

/// All contenders in turn, round by round, at prime sizes. One that throws is left out of the
/// result. None where the listener ended it.
std::optional<std::vector<SizeCurve>> runSizeStudy(const std::vector<LabContender> &contenders,
                                                   int rounds,
                                                   const ProgressListener &listener = {});

/// How far increments have drifted after so many columns, and what they may by proof.
struct DriftPoint {
    std::int64_t column = 0; ///< counted from the first
    double error = 0; ///< px, the larger of the two bounds' magnitudes
    double limit = 0; ///< px (core/compare/bounderrors.h)

    friend bool operator==(const DriftPoint &, const DriftPoint &) = default;
};
struct DriftCurve {
    Arithmetic arithmetic = Arithmetic::Float32;
    std::vector<DriftPoint> points;

    friend bool operator==(const DriftCurve &, const DriftCurve &) = default;
};

/// Of the column scan over a triangle of so many columns, a prime number, in every arithmetic that
/// rounds; no curves where that fails. None where the listener ended it.
std::optional<std::vector<DriftCurve>> driftOver(std::int64_t columns,
                                                 const ProgressListener &listener = {});

} // namespace pixelplumb
