// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programwalk.h"

#include <vector>

namespace pixelplumb {

/// A mistake in a walk and what is said of it. In the words %1 is a span, %2 the coordinate that
/// its samples share, %3 the other one, %4 its lower bound; of edges %5 is the way from a vertex to
/// its first span and %6 that to the one before.
struct WalkRow {
    const char *id;
    const char *forStudent;
    const char *forAssistant;
    ProgramWalk walk;
    LevelOverflow overflow = LevelOverflow::Clamps;
};

/// Of what is done along a span: from which end spans are gone through makes no difference.
const std::vector<WalkRow> &spanWalkRows();
/// Of the colours along a span, where neither does it.
const std::vector<WalkRow> &spanColourRows();
/// Of what is done along edges, where it does.
const std::vector<WalkRow> &edgeWalkRows();
/// Of columns alone: of rows the lesser x is the left bound, whatever the slopes are.
const std::vector<WalkRow> &columnWalkRows();
/// Of the colours along edges and of what they are divided by.
const std::vector<WalkRow> &edgeColourRows();
/// Of what tells the three edges apart: where the first short one ends and the second begins, what
/// the long one does there, and what one of them alone has.
const std::vector<WalkRow> &middleWalkRows();
/// Of edges with the rise, the run or the rate of another one.
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
