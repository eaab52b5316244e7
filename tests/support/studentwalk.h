// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

#include <set>

namespace pixelplumb {

/// What is wrong in a student's program.
enum class WalkMistake {
    FromBelow, ///< no mistake: rows from the least y up
    NoEdgePreStep,
    NoEdgeColourPreStep,
    EdgeDivisorMinusOne,
    EdgeDivisorPlusOne,
    UnsortedColours,
    WholeSlopes,
    WholeEdgeColours,
    WholePreSteps,
    WholeSteps,
    SpanDivisorPlusOne,
    ColoursBetweenSamples,
    LastSpanMissing, ///< x < ⌊x₂⌋
    OpenAtLastVertex, ///< x < x₂
    FirstSpanMissing, ///< from ⌈x₀⌉ + 1
    OpenAtFirstVertex, ///< x > x₀
    FirstHalfTruncated, ///< x < ⌊x₁⌋
    SecondHalfAfterCeiling, ///< from ⌈x₁⌉ + 1
    SecondHalfAfterFloor, ///< from ⌊x₁⌋ + 1
    SecondHalfWithoutPreStep,
    NoFirstHalf,
    NoSecondHalf,
    LoopsTruncated, ///< from (int)x₀ with y₀ to (int)x₁, on with y₁ to (int)x₂
    DividesDown, ///< no mistake by itself: // of Python where others divide as C does
    WholeSpanLevels, ///< int r = …; r += ΔR;
    WholeEdgeLevels,
    LongEdgeAlwaysUpper,
    LongEdgeAlwaysLower,
};

enum class WalkLines { Columns, Rows };

/// What a student's own program draws of a scene of triangles, in fractions: the two loops of the
/// assignment, written from its text alone and without anything of the core's kernels. Of rows the
/// greatest y comes first, but for FromBelow.
Picture studentPicture(const Scene &scene, WalkLines lines, const std::set<WalkMistake> &mistakes);
/// The same in numbers that round.
Picture studentPictureInDouble(const Scene &scene, WalkLines lines,
                               const std::set<WalkMistake> &mistakes);

} // namespace pixelplumb
