// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/drawnline.h"

#include <optional>

namespace pixelplumb {

/// A number computed from Δx ≥ Δy ≥ 0, along the line and across it, px.
using DecisionTerm = std::int64_t (*)(std::int64_t dx, std::int64_t dy);

enum class StepsAcross { WherePositive, WhereNegative };

/// How p is updated from pixel to pixel.
enum class DecisionUpdate {
    AfterTest, ///< by the term of the pixel that was chosen
    AddsAlways, ///< a step across adds both terms
    BeforeTest, ///< the term for staying is added before p is tested
    SetBack, ///< p starts anew after a step across
};

/// A line's first p: set anew, or carried over from the line before.
enum class DecisionStart { Anew, OfLineBefore };

/// The first p, and what is added when the line stays or steps across; Bresenham's by default.
struct LineDecision {
    DecisionTerm first = [](std::int64_t dx, std::int64_t dy) { return 2 * dy - dx; };
    DecisionTerm stay = [](std::int64_t, std::int64_t dy) { return 2 * dy; };
    DecisionTerm cross = [](std::int64_t dx, std::int64_t dy) { return 2 * dy - 2 * dx; };
    StepsAcross steps = StepsAcross::WherePositive;
    DecisionUpdate update = DecisionUpdate::AfterTest;
    DecisionStart start = DecisionStart::Anew;
};

/// The end where steps begin.
enum class LineStart {
    FirstEnd, ///< as given
    LeastAlong, ///< the lesser x, or y for steep lines
    LeastX, ///< the lesser x, also for steep lines: sorted before x and y are exchanged
    LeastXOfFlat, ///< the lesser x; steep lines start as given
    LeastYOfSteep, ///< the lesser y; flat lines start as given
};

/// What happens to a line whose steps would descend along it: to the left, or downward for steep
/// lines.
enum class DescendingLine { Drawn, Lost, FirstPixelAlone, Ascends };

/// Where a step across goes.
enum class AcrossStep { TowardsEnd, Upward, Downward, AwayFromEnd, NoneDownward };

/// For which lines x and y are exchanged.
enum class SteepLine {
    Exchanged,
    AsFlat, ///< for no line
    Inverted, ///< for flat lines
    OwnDifferences, ///< for steep lines, but Δx and Δy are not exchanged
    BySignedDifferences, ///< where Δy > Δx with their signs
};

/// Where the loop ends.
enum class LastStep { AtEnd, OnePast };

enum class LineColours {
    Right,
    DividedByOneMore, ///< Δ + 1
    DividedByOneLess,
    WholeIncrements, ///< (C₁ − C₀)/Δ truncated toward 0
    FlooredIncrements, ///< … rounded down
    OneAhead, ///< stepped before the first pixel is drawn
    OfStart, ///< the start's colour only
    AsGiven, ///< not sorted along with the ends
};

/// A program that draws lines between samples by Bresenham's steps; right by default.
struct ProgramLine {
    LineDecision decision = {};
    LineStart start = LineStart::FirstEnd;
    DescendingLine descending = DescendingLine::Drawn;
    AcrossStep across = AcrossStep::TowardsEnd;
    SteepLine steep = SteepLine::Exchanged;
    LastStep last = LastStep::AtEnd;
    LineColours colours = LineColours::Right;
};

/// The scene of lines as drawn by this program; lines not between samples are unchanged.
Picture drawnBy(const ProgramLine &program, const Scene &scene);

} // namespace pixelplumb
