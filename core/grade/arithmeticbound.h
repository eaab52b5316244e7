// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/scan/edgeteststate.h"
#include "core/scan/scansettings.h"
#include "core/scan/spanaxis.h"

#include <array>
#include <optional>

namespace pixelplumb {

/// Whether a triangle holds a sample for every right program; undecided: rounding decides it.
enum class Containment { Inside, Outside, Undecided };

struct LevelRange {
    double least = 0;
    double most = 0;
};

/// How far a right program may be off on one triangle, in sample coordinates, if it walks between
/// two edges, from any column or row of theirs, or asks edge functions (barycentric ones among
/// them) and rounds every operation: the proofs stand in resources/numerics.md, 3.9.
class ArithmeticBound {
public:
    /// In float32 or float64.
    ArithmeticBound(const Triangle &triangle, Arithmetic arithmetic);

    /// False for vertices beyond 2^16 px, which float32 does not hold, and without area.
    bool isProved() const { return m_isProved; }
    Containment containmentOf(std::int64_t x, std::int64_t y) const;
    /// The samples of the frame that a right program may write: of all others it is sure.
    SampleBox reachIn(const FrameSpec &frame) const;
    /// What y_B and y_T of a column, or x_L and x_R of a row, may be off by, px; infinite for
    /// vertices beyond 2^16 px.
    double endError(SpanAxis axis) const;
    /// What a level may be off by at a sample inside; none: by anything.
    std::optional<double> levelError(std::int64_t x, std::int64_t y, std::size_t channel) const;
    /// The levels that a right program may have at a sample that it draws: those near the exact
    /// one, and on a thin span, or of a triangle without area, those between the vertices' (a start
    /// at one end and a part of the way to the other); none: any.
    std::optional<LevelRange> levelsAt(std::int64_t x, std::int64_t y, std::size_t channel) const;

    /// What an edge function may be off by, px².
    double functionError() const { return m_functionError; }
    /// What an operation may be off by, of its result.
    double unit() const { return m_unit; }

    /// What a level may be off by of who walks by columns and adds this rate from sample to sample.
    double spanLevelError(double rate) const;

private:
    /// As who walks by columns, or by rows, is sure of it.
    Containment containmentAlong(const std::array<double, 3> &edgeFunctions, SpanAxis walk) const;

    Triangle m_triangle;
    Triangle m_exchanged; ///< x and y exchanged
    double m_unit = 0; ///< 2^-24 or 2^-53
    double m_largest = 0; ///< px, of all coordinates
    double m_area = 0; ///< doubled, px²
    double m_columnError = 0; ///< of y_B and y_T, px
    double m_rowError = 0; ///< of x_L and x_R, px
    double m_functionError = 0; ///< of an edge function, px²
    double m_columnLevelError = 0; ///< of a level along an edge
    double m_rowLevelError = 0;
    std::array<double, 2> m_extent = {}; ///< of x and y, px
    std::array<std::array<double, 2>, 3> m_gradient = {}; ///< levels a pixel of x and y, a channel
    bool m_isProved = false;
};

} // namespace pixelplumb
