// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/drawnline.h"

#include <optional>

namespace pixelplumb {

/// A number made of Δx ≥ Δy ≥ 0, along the line and across it, px.
using DecisionTerm = std::int64_t (*)(std::int64_t dx, std::int64_t dy);

enum class StepsAcross { WherePositive, WhereNegative };

/// How p goes on from one pixel to the next.
enum class DecisionUpdate {
    AfterTest, ///< by what belongs to the pixel that was chosen
    AddsAlways, ///< where the line steps across both are added
    BeforeTest, ///< what is added where the line stays is added before p is asked
    SetBack, ///< where the line steps across p begins anew
};

/// What a line's first p is; that of the line before is carried on where it is not set anew.
enum class DecisionStart { Anew, OfLineBefore };

/// What p begins with, what is added where the line stays and where it steps across; Bresenham's as
/// it stands.
struct LineDecision {
    DecisionTerm first = [](std::int64_t dx, std::int64_t dy) { return 2 * dy - dx; };
    DecisionTerm stay = [](std::int64_t, std::int64_t dy) { return 2 * dy; };
    DecisionTerm cross = [](std::int64_t dx, std::int64_t dy) { return 2 * dy - 2 * dx; };
    StepsAcross steps = StepsAcross::WherePositive;
    DecisionUpdate update = DecisionUpdate::AfterTest;
    DecisionStart start = DecisionStart::Anew;
};

/// At which end steps begin.
enum class LineStart {
    FirstEnd, ///< as given
    LeastAlong, ///< the lesser x, of steep lines y
    LeastX, ///< the lesser x, of steep lines, too: sorted before x and y are exchanged
    LeastXOfFlat, ///< the lesser x; steep lines as given
    LeastYOfSteep, ///< the lesser y; flat lines as given
};

/// What becomes of a line whose steps would go down along it: to the left, of steep lines downward.
enum class DescendingLine { Drawn, Lost, FirstPixelAlone, Ascends };

/// Where a step across goes.
enum class AcrossStep { TowardsEnd, Upward, Downward, AwayFromEnd, NoneDownward };

/// For which lines x and y are exchanged.
enum class SteepLine {
    Exchanged,
    AsFlat, ///< for none
    Inverted, ///< for those that are flat
    OwnDifferences, ///< but Δx and Δy are not
    BySignedDifferences, ///< where Δy > Δx, signs and all
};

/// How far the loop goes.
enum class LastStep { AtEnd, OnePast };

enum class LineColours {
    Right,
    DividedByOneMore, ///< Δ + 1
    DividedByOneLess,
    WholeIncrements, ///< (C₁ − C₀)/Δ cut toward 0
    FlooredIncrements, ///< … cut downward
    OneAhead, ///< stepped before the first pixel is drawn
    OfStart, ///< that end's alone
    AsGiven, ///< ends are sorted without them
};

/// A program that draws lines between samples by Bresenham's steps; a right one as it stands.
struct ProgramLine {
    LineDecision decision = {};
    LineStart start = LineStart::FirstEnd;
    DescendingLine descending = DescendingLine::Drawn;
    AcrossStep across = AcrossStep::TowardsEnd;
    SteepLine steep = SteepLine::Exchanged;
    LastStep last = LastStep::AtEnd;
    LineColours colours = LineColours::Right;
};

/// Whether it is a scene of lines whose method asks p, and p = 0 can go either way.
bool hasDecisions(const Scene &scene);

/// The same scene, p = 0 going the other way than it has it: across or not.
Scene withOtherTies(Scene scene);

/// The scene of lines as such a program draws it; lines between samples stay as they are.
Picture drawnBy(const ProgramLine &program, const Scene &scene);

} // namespace pixelplumb
