// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/oracle/oracle.h"
#include "core/scan/boundaryrule.h"
#include "core/scan/scansettings.h"
#include "core/scan/spanaxis.h"
#include "core/scan/tests/edgeteststate.h"

#include <array>
#include <optional>
#include <utility>

namespace pixelplumb {

/// Whether a triangle contains a sample for every right program; undecided: rounding decides.
enum class Containment { Inside, Outside, Undecided };

struct LevelRange {
    double least = 0;
    double most = 0;

    /// The least and the largest byte to which a level within the range is rounded.
    std::pair<int, int> bytes(ByteRounding rounding) const;
    bool hasByte(int byte, ByteRounding rounding) const
    {
        const auto [first, last] = bytes(rounding);
        return first <= byte && byte <= last;
    }
};

/// Ways to compute whether a triangle has a sample, a bit each: a walk along columns, along rows,
/// edge functions that round, and edge functions that do not, with one of the three weights
/// computed as 1 − α − β: of which edge, in which numbers, by quotients or by the reciprocal of the
/// area, and in which order. A program keeps to one of them.
using ProgramWays = std::uint64_t;
inline constexpr ProgramWays allProgramWays = ~ProgramWays(0);

/// The largest error of a right program on one triangle, in sample coordinates, if it walks between
/// two edges, from any of their columns or rows, or evaluates edge functions (barycentric ones
/// included) and rounds every operation. Proofs: resources/numerics.md, 3.9.
class ArithmeticBound {
public:
    /// For float32 or float64.
    ArithmeticBound(const Triangle &triangle, Arithmetic arithmetic);

    /// False without area and for vertices beyond 2^16 px, which float32 does not hold.
    bool isProved() const { return m_isProved; }
    /// A sample on an edge where nothing rounds is decided by the fill rule; none: undecided. Of
    /// the programs that compute in one of these ways.
    Containment containmentOf(std::int64_t x, std::int64_t y,
                              const std::optional<BoundaryRule> &rule,
                              ProgramWays ways = allProgramWays) const;
    /// The ways that may decide a sample otherwise than the rule does without rounding.
    ProgramWays deviatingAt(std::int64_t x, std::int64_t y,
                            const std::optional<BoundaryRule> &rule) const
    {
        return deviatingWays(sampleAt(x, y, rule), x, y, rule);
    }
    /// Like containmentOf() for programs that evaluate edge functions alone.
    Containment containmentByFunctions(std::int64_t x, std::int64_t y,
                                       const std::optional<BoundaryRule> &rule) const
    {
        return m_isProved ? byFunctions(sampleAt(x, y, rule), rule) : Containment::Undecided;
    }
    /// The frame's samples that a right program may write; it never writes any other.
    SampleBox reachIn(const FrameSpec &frame) const;
    /// The error of y_B and y_T of a column, or x_L and x_R of a row, px; infinite for vertices
    /// beyond 2^16 px.
    double endError(SpanAxis axis) const;
    /// The error of a level at a sample inside; none: unbounded.
    std::optional<double> levelError(std::int64_t x, std::int64_t y, std::size_t channel) const;
    /// The levels that a right program may have at a sample it draws: those near the exact one; on
    /// a span so thin that its increment may be anything, those between its two ends; for a
    /// triangle without area, those between the vertices; none: any.
    std::optional<LevelRange> levelsAt(std::int64_t x, std::int64_t y, std::size_t channel) const;

    /// The error of an edge function, px².
    double functionError() const { return m_functionError; }
    /// The relative error of one operation.
    double unit() const { return m_unit; }

    /// The error of a level in a program that walks by columns and adds this rate at each sample.
    double spanLevelError(double rate) const;

private:
    static constexpr double levels = 256;
    static constexpr double largestProved = 65536; ///< px

    struct Sample {
        std::array<double, 3> functions = {}; ///< px²
        std::array<bool, 3> areOwned = {}; ///< by the fill rule, on the edge's line
    };
    /// The column of a walk by columns, or the row of one by rows, x and y exchanged; none outside.
    std::optional<oracle::ExactColumn> spanAt(SpanAxis walk, std::int64_t x, std::int64_t y) const;
    bool isThin(const oracle::ExactColumn &span, SpanAxis walk) const;
    /// The error of a level at a sample inside: of a walk on a span that is not thin, and by edge
    /// functions.
    double walkLevelError(SpanAxis walk, std::size_t channel) const;
    double functionLevelError() const;
    Sample sampleAt(std::int64_t x, std::int64_t y, const std::optional<BoundaryRule> &rule) const;
    /// The containment by edge functions with these errors, px².
    static Containment containmentWithin(const Sample &sample, const std::array<double, 3> &errors,
                                         const std::optional<BoundaryRule> &rule);
    Containment byFunctions(const Sample &sample, const std::optional<BoundaryRule> &rule) const;
    Containment byWalk(const Sample &sample, SpanAxis walk, std::int64_t at,
                       const std::optional<BoundaryRule> &rule) const;
    std::array<Lattice, 3> placesAlong(SpanAxis walk) const;
    void setWalkErrors();
    bool isWalkedExactly(std::size_t edge, SpanAxis walk) const;
    bool areFunctionsExact() const;
    ProgramWays deviatingWays(const Sample &sample, std::int64_t x, std::int64_t y,
                              const std::optional<BoundaryRule> &rule) const;
    ProgramWays deviatingThirdWeights(const Sample &sample,
                                      const std::optional<BoundaryRule> &rule) const;

    Triangle m_triangle;
    Triangle m_exchanged; ///< with x and y exchanged
    double m_unit = 0; ///< 2^-24 or 2^-53
    double m_largest = 0; ///< px, of all coordinates
    double m_area = 0; ///< doubled, px²
    double m_columnError = 0; ///< of y_B and y_T, px
    double m_rowError = 0; ///< of x_L and x_R, px
    double m_functionError = 0; ///< of an edge function, px²
    bool m_hasExactFunctions = false; ///< nothing rounds in them but a division by the area
    /// Errors of walks by columns and by rows as those of edge functions, px²: 0 where nothing
    /// rounds.
    std::array<std::array<double, 3>, 2> m_walkErrors = {};
    double m_columnLevelError = 0; ///< of a level along an edge
    double m_rowLevelError = 0;
    std::array<double, 2> m_extent = {}; ///< in x and y, px
    std::array<std::array<double, 2>, 3> m_gradient = {}; ///< levels per px in x, y; by channel
    bool m_isProved = false;
};

} // namespace pixelplumb
