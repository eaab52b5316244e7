// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scanbugs.h"

#include <vector>

namespace pixelplumb {

/// A mistake of a program that walks along edges, and its texts. In the texts %1 is a span, %2 the
/// coordinate that its samples share, %3 the other one, %4 its lower bound; for edges %5 is the
/// distance from a vertex to its first span and %6 that to the span before.
struct WalkRow {
    const char *id;
    const char *forStudent;
    const char *forAssistant;
    ScanBugs bugs;
};

/// Mistakes along a span and in its colours.
const std::vector<WalkRow> &spanWalkRows();
const std::vector<WalkRow> &spanColourRows();
/// Mistakes along edges, in what is a whole number there, in the colours along them and in their
/// divisors.
const std::vector<WalkRow> &edgeWalkRows();
const std::vector<WalkRow> &numberWalkRows();
const std::vector<WalkRow> &edgeColourRows();
/// Mistakes that distinguish the three edges: where the first short one ends and the second begins,
/// what the long one does there, and what only one of them has.
const std::vector<WalkRow> &middleWalkRows();
/// Mistakes of edges that use the rise, the run or the rate of another one.
const std::vector<WalkRow> &mistakenRateRows();

namespace walkquestions {

inline constexpr const char *division = "What does a division of two whole numbers give you?";
inline constexpr const char *stored = "What type has a colour while it is stepped?";
inline constexpr const char *bounds
    = "Which bound of a %1 has which colour? Whichever edge is the lower one?";
inline constexpr const char *triangleEnds
    = "At which %1 does a triangle begin, and at which does it end, where a vertex lies between "
      "two?";
inline constexpr const char *edgeDivisor
    = "How many steps does an edge take from one vertex to the next?";
inline constexpr const char *middle
    = "Which edge ends at the middle vertex, which begins there, and which goes on?";
inline constexpr const char *differences
    = "Between which two vertices is each of the three edges? Above and below the fraction bar?";
inline constexpr const char *channels = "Are all three channels treated alike?";

} // namespace walkquestions

} // namespace pixelplumb
