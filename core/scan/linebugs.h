// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

/// The mistakes of a program that draws lines, as settings of the mistaken line
/// (grade/scan/programline.h).
namespace pixelplumb {

/// What the decision p begins with, or is added to it, computed from Δx ≥ Δy ≥ 0, along the line
/// and across it: the right term, or one of these.
enum class DecisionTerm : std::uint8_t {
    Right,
    Nothing,
    Rise, ///< Δy
    TwiceRise, ///< 2Δy
    Difference, ///< Δy − Δx
    TwiceDifference, ///< 2Δy − 2Δx
    Midpoint, ///< 2Δy − Δx
    MidpointNegated, ///< Δx − 2Δy
    HalfMidpoint, ///< Δy − Δx/2, as whole numbers are divided
    Sum, ///< 2Δy + Δx
    Exchanged, ///< 2Δx − Δy
    TwiceRun, ///< 2Δx
    RunNegated, ///< −Δx
    TwiceRunNegated, ///< −2Δx
    WholeSlope, ///< 1 where Δy is Δx, else −1
};

enum class StepsAcross : std::uint8_t { WherePositive, WhereNegative };

/// How p is updated from pixel to pixel: by the term of the pixel that was chosen; a step across
/// adds both terms; the term for staying is added before p is tested; or p starts anew after a step
/// across.
enum class DecisionUpdate : std::uint8_t { AfterTest, AddsAlways, BeforeTest, SetBack };

/// A line's first p: set anew, or carried over from the line before.
enum class DecisionStart : std::uint8_t { Anew, OfLineBefore };

/// The end where steps begin.
enum class LineStart : std::uint8_t {
    OfMethod, ///< as in the method's own line, where nothing else about the steps is wrong
    FirstEnd, ///< as given
    LeastAlong, ///< the lesser x, or y for steep lines
    LeastX, ///< the lesser x, also for steep lines: sorted before x and y are exchanged
    LeastXOfFlat, ///< the lesser x; steep lines start as given
    LeastYOfSteep, ///< the lesser y; flat lines start as given
};

/// What happens to a line whose steps would descend along it: to the left, or downward for steep
/// lines.
enum class DescendingLine : std::uint8_t { Drawn, Lost, FirstPixelAlone, Ascends };

/// Where a step across goes.
enum class AcrossStep : std::uint8_t { TowardsEnd, Upward, Downward, AwayFromEnd, NoneDownward };

/// For which lines x and y are exchanged: steep ones; none; flat ones; steep ones, but Δx and Δy
/// are not exchanged; or those with Δy > Δx by their signs.
enum class SteepLine : std::uint8_t {
    Exchanged,
    AsFlat,
    Inverted,
    OwnDifferences,
    BySignedDifferences
};

/// Where the loop ends.
enum class LastStep : std::uint8_t { AtEnd, OnePast };

/// How the colour is stepped: by the right increments; divided by Δ + 1 or by Δ − 1; by whole ones,
/// cut toward 0 or down; stepped before the first pixel is drawn; not at all from the start's
/// colour; or from that of the other end, as colours are not sorted along with the ends.
enum class LineColours : std::uint8_t {
    Right,
    DividedByOneMore,
    DividedByOneLess,
    WholeIncrements,
    FlooredIncrements,
    OneAhead,
    OfStart,
    AsGiven
};

/// Which pixel across a step draws: the nearest; ⌊v⌋; or of two as near the lower one, ⌈v − ½⌉.
enum class AcrossRounding : std::uint8_t { Nearest, Down, HalvesDown };
/// How many pixels steep lines have: one a row, or one a column.
enum class SteepPixels : std::uint8_t { OneARow, OneAColumn };
/// Where steep lines' pixels are written: in their places, or with x and y exchanged.
enum class SteepWriting : std::uint8_t { InPlace, Exchanged };
/// The end whose pixel is left out: the first or second as given, or that with the lesser or the
/// greater x, of steep lines y.
enum class MissingEnd : std::uint8_t { None, First, Last, Least, Greatest };

/// What a program that draws lines does wrong. Each setting is one byte, 0 where it is right.
struct LineBugs {
    // Of Bresenham's steps between samples.
    DecisionTerm first = DecisionTerm::Right; ///< the first p
    DecisionTerm stay = DecisionTerm::Right; ///< what is added where the line stays
    DecisionTerm cross = DecisionTerm::Right; ///< what is added where it steps across
    StepsAcross steps = StepsAcross::WherePositive;
    DecisionUpdate update = DecisionUpdate::AfterTest;
    DecisionStart decisionStart = DecisionStart::Anew;
    LineStart start = LineStart::OfMethod;
    DescendingLine descending = DescendingLine::Drawn;
    AcrossStep across = AcrossStep::TowardsEnd;
    SteepLine steep = SteepLine::Exchanged;
    LastStep last = LastStep::AtEnd;
    LineColours colours = LineColours::Right;
    // Of the pixels of any method.
    AcrossRounding rounding = AcrossRounding::Nearest;
    SteepPixels steepPixels = SteepPixels::OneARow;
    SteepWriting steepWriting = SteepWriting::InPlace;
    MissingEnd missing = MissingEnd::None;

    /// Whether a line's steps are the program's, not those of the scene's method.
    constexpr bool stepsItself() const { return start != LineStart::OfMethod; }
    friend constexpr bool operator==(const LineBugs &, const LineBugs &) = default;
};

/// The bugs of a program that has both; none where they change the same setting, or what one
/// changes hides the other. Two programs that begin at the same end begin there together.
constexpr std::optional<LineBugs> together(const LineBugs &one, const LineBugs &other)
{
    using Bytes = std::array<std::uint8_t, sizeof(LineBugs)>;
    LineBugs added = other;
    if (added.start == one.start)
        added.start = LineStart::OfMethod;
    auto both = std::bit_cast<Bytes>(one);
    const auto bytes = std::bit_cast<Bytes>(added);
    for (std::size_t place = 0; place < both.size(); ++place) {
        if (both[place] != 0 && bytes[place] != 0)
            return std::nullopt;
        both[place] |= bytes[place];
    }
    const auto bugs = std::bit_cast<LineBugs>(both);
    // Which pixels are drawn is then not asked of the steps.
    const bool hidesSteps = bugs.stepsItself()
        && (bugs.rounding != AcrossRounding::Nearest || bugs.steepPixels != SteepPixels::OneARow);
    return hidesSteps ? std::nullopt : std::optional(bugs);
}

} // namespace pixelplumb
