// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"

namespace pixelplumb {

/// The error axis of a chart: a row of a table.
struct ErrorAxis {
    const char *id; ///< "wrong-pixels"
    const char *title; ///< "wrong pixels"
    const char *unit; ///< "ppm"
    /// None if it was not measured.
    std::optional<double> (*read)(const AccuracyFigures &figures);
};
/// Wrong pixels, wrong coverage, wrong bytes (ppm), the largest byte error, the largest and the RMS
/// level error before rounding (levels), the farthest miss (px).
std::span<const ErrorAxis> errorAxes();
const ErrorAxis *errorAxisNamed(const QString &id);

/// An error of 0 has no place on a logarithmic axis; it has rows of its own.
enum class ErrorClass : std::uint8_t {
    Positive,
    ZeroObserved, ///< over some number of pixels
    ZeroTested, ///< for a fast kernel: proved for the plain one, whose bytes it is tested to write
    ZeroProved,
};

/// A contender on the chart.
struct ParetoPoint {
    QString contender;
    QString label;
    LabKernel kernel = LabKernel::Plain;
    Spread cost; ///< ns a pixel
    std::optional<double> timesReference; ///< relative to the assignment's method, ×1
    std::optional<Spread> straight; ///< ns a pixel: the hollow dot next to it
    std::optional<double> missesStraight;
    ErrorClass errorClass = ErrorClass::Positive;
    double error = 0; ///< in the axis' unit
    std::int64_t pixels = 0; ///< observed
    bool isOnFrontier = false;

    /// The assignment's method.
    bool isReference() const { return contender == QLatin1String(referenceContenderId); }
};

/// Whether a is as cheap and as exact as b, and better in one of the two. Proved is better than
/// tested, and tested than observed. Only for equally built kernels: no SIMD kernel beats a plain
/// one, nor the reverse.
bool dominates(const ParetoPoint &a, const ParetoPoint &b);

/// A place on the staircase of the frontier.
struct StaircaseCorner {
    double cost = 0; ///< ns a pixel
    ErrorClass errorClass = ErrorClass::Positive;
    double error = 0;

    friend bool operator==(const StaircaseCorner &, const StaircaseCorner &) = default;
};

struct ParetoChart {
    QString family;
    QString axis;
    std::vector<ParetoPoint> points; ///< of the rows that have both
    /// Rows that have an error and no time, or none yet; they have no cost.
    std::vector<ParetoPoint> untimed;

    /// Indices of points that no other of the kernel dominates, cheapest first.
    std::vector<std::size_t> frontier(LabKernel kernel) const;
    /// Goes right from each point of that frontier, then down to the next.
    std::vector<StaircaseCorner> staircase(LabKernel kernel) const;
};

ParetoChart paretoOf(const Study &study, const QString &family, const ErrorAxis &axis);

} // namespace pixelplumb
