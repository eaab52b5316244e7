// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/linedefect.h"

namespace pixelplumb {

namespace {

constexpr const char *octantQuestion = "Does it hold in all eight octants?";
constexpr const char *endQuestion = "Is each end's pixel drawn, once?";
constexpr const char *lineColourQuestion
    = "By how much does the colour change from pixel to pixel, and which colour has the first one?";

} // namespace

const std::vector<LineRow> &lineStepRows()
{
    static const std::vector<LineRow> rows = {
        {"one-pixel-too-many",
         endQuestion,
         "A line goes a pixel too far",
         {.last = LastStep::OnePast}},
        {"steps-across-upward",
         octantQuestion,
         "Steps across go upward always, of steep lines to the right",
         {.across = AcrossStep::Upward}},
        {"steps-across-downward",
         octantQuestion,
         "Steps across go downward always, of steep lines to the left",
         {.across = AcrossStep::Downward}},
        {"steps-across-backward",
         octantQuestion,
         "Steps across go the other way",
         {.across = AcrossStep::AwayFromEnd}},
        {"steep-lines-as-flat",
         octantQuestion,
         "Steep lines step across at each step, and only Δx times: neither x and y nor Δx and Δy "
         "are exchanged for them, or only one of these",
         {.steep = SteepLine::AsFlat}},
        {"steep-by-signed-differences",
         octantQuestion,
         "A line is taken to be steep where Δy > Δx, and not |Δy| > |Δx|",
         {.steep = SteepLine::BySignedDifferences}},
        {"steepness-inverted",
         octantQuestion,
         "x and y are exchanged for flat lines, |Δy| < |Δx|, and not for steep ones: all lines "
         "step across at each step, as often as they should step across",
         {.steep = SteepLine::Inverted}},
        {"first-octant-alone",
         octantQuestion,
         "Steep lines step across at each step, only Δx times, and lines that fall stay in their "
         "first row: the steps are those of the first octant",
         {.across = AcrossStep::NoneDownward, .steep = SteepLine::AsFlat}},
        {"line-colours-by-pixels",
         lineColourQuestion,
         "Increments of colour are divided by the number of pixels, Δ + 1, in place of steps",
         {.colours = LineColours::DividedByOneMore}},
        {"line-colours-by-one-less",
         lineColourQuestion,
         "Increments of colour are divided by Δ − 1 in place of Δ",
         {.colours = LineColours::DividedByOneLess}},
        {"line-increments-cut",
         lineColourQuestion,
         "Increments of colour are whole numbers, cut towards 0",
         {.colours = LineColours::WholeIncrements}},
        {"line-increments-floored",
         lineColourQuestion,
         "Increments of colour are whole numbers, cut downward",
         {.colours = LineColours::FlooredIncrements}},
        {"line-colours-ahead",
         lineColourQuestion,
         "The colour is stepped before a line's first pixel is drawn",
         {.colours = LineColours::OneAhead}},
    };
    return rows;
}

const std::vector<LineRow> &lineEndRows()
{
    static const std::vector<LineRow> rows = {
        {"descending-lines-lost",
         octantQuestion,
         "Lines whose second end is left of the first, of steep lines below it, are not drawn: the "
         "loop goes upward alone.",
         {.start = LineStart::FirstEnd, .descending = DescendingLine::Lost}},
        {"descending-lines-of-one-pixel",
         octantQuestion,
         "Lines whose second end is left of the first, of steep lines below it, are their first "
         "pixel alone: the loop goes upward alone.",
         {.start = LineStart::FirstEnd, .descending = DescendingLine::FirstPixelAlone}},
        {"descending-lines-ascend",
         octantQuestion,
         "Lines whose second end is left of the first, of steep lines below it, are drawn upward "
         "from there: the loop goes upward alone.",
         {.start = LineStart::FirstEnd, .descending = DescendingLine::Ascends}},
        {"steep-falling-lines-lost",
         octantQuestion,
         "Steep lines that fall from left to right, for their ends are sorted by x, are not drawn: "
         "the loop goes upward alone.",
         {.start = LineStart::LeastX, .descending = DescendingLine::Lost}},
        {"steep-falling-lines-of-one-pixel",
         octantQuestion,
         "Steep lines that fall from left to right, for their ends are sorted by x, are their "
         "first pixel alone: the loop goes upward alone.",
         {.start = LineStart::LeastX, .descending = DescendingLine::FirstPixelAlone}},
        {"steep-falling-lines-ascend",
         octantQuestion,
         "Steep lines that fall from left to right, for their ends are sorted by x, are drawn "
         "upward from there: the loop goes upward alone.",
         {.start = LineStart::LeastX, .descending = DescendingLine::Ascends}},
        {"flat-backward-lines-lost",
         octantQuestion,
         "Flat lines whose second end is left of the first, for steep ones alone are sorted, are "
         "not drawn: the loop goes upward alone.",
         {.start = LineStart::LeastYOfSteep, .descending = DescendingLine::Lost}},
        {"flat-backward-lines-of-one-pixel",
         octantQuestion,
         "Flat lines whose second end is left of the first, for steep ones alone are sorted, are "
         "their first pixel alone: the loop goes upward alone.",
         {.start = LineStart::LeastYOfSteep, .descending = DescendingLine::FirstPixelAlone}},
        {"flat-backward-lines-ascend",
         octantQuestion,
         "Flat lines whose second end is left of the first, for steep ones alone are sorted, are "
         "drawn upward from there: the loop goes upward alone.",
         {.start = LineStart::LeastYOfSteep, .descending = DescendingLine::Ascends}},
        {"steep-descending-lines-lost",
         octantQuestion,
         "Steep lines whose second end is below the first, for flat ones alone are sorted, are not "
         "drawn: the loop goes upward alone.",
         {.start = LineStart::LeastXOfFlat, .descending = DescendingLine::Lost}},
        {"steep-descending-lines-of-one-pixel",
         octantQuestion,
         "Steep lines whose second end is below the first, for flat ones alone are sorted, are "
         "their first pixel alone: the loop goes upward alone.",
         {.start = LineStart::LeastXOfFlat, .descending = DescendingLine::FirstPixelAlone}},
        {"steep-descending-lines-ascend",
         octantQuestion,
         "Steep lines whose second end is below the first, for flat ones alone are sorted, are "
         "drawn upward from there: the loop goes upward alone.",
         {.start = LineStart::LeastXOfFlat, .descending = DescendingLine::Ascends}},
        {"first-octant-unsorted",
         octantQuestion,
         "The steps are those of the first octant: lines whose second end is left of the first are "
         "not drawn, steep ones step across at each step, falling ones stay in their first row.",
         {.start = LineStart::FirstEnd,
          .descending = DescendingLine::Lost,
          .across = AcrossStep::NoneDownward,
          .steep = SteepLine::AsFlat}},
        // From a line's first end this would be steep-lines-as-flat.
        {"sorted-steep-lines-by-own-differences",
         octantQuestion,
         "Of steep lines x and y are exchanged, Δx and Δy are not: from the end with the lesser y "
         "they step across at each step, only Δx times.",
         {.start = LineStart::LeastAlong, .steep = SteepLine::OwnDifferences}},
        // From a line's first end these would be a scene's defect of all methods.
        {"sorted-falling-lines-level",
         octantQuestion,
         "Lines that fall from left to right stay in their first row, steep ones that go up and to "
         "the left in their first column: Δy is negative, and so is p.",
         {.start = LineStart::LeastAlong, .across = AcrossStep::NoneDownward}},
        {"lines-of-left-colour",
         lineColourQuestion,
         "A line has the colour of the end with the lesser x, of steep lines y, alone.",
         {.start = LineStart::LeastAlong, .colours = LineColours::OfStart}},
        {"line-colours-not-sorted",
         lineColourQuestion,
         "The ends are sorted by x, of steep lines by y, and their colours are not.",
         {.start = LineStart::LeastAlong, .colours = LineColours::AsGiven}},
    };
    return rows;
}

const std::vector<LineRow> &linePixelRows()
{
    static const std::vector<LineRow> rows = {
        {"first-pixel-missing",
         endQuestion,
         "A line's first pixel is left out.",
         {.missing = MissingEnd::First}},
        {"last-pixel-missing",
         endQuestion,
         "The pixel of a line's second end is left out.",
         {.missing = MissingEnd::Last}},
        {"least-pixel-missing",
         endQuestion,
         "The pixel of the end with the lesser x, of steep lines y, is left out.",
         {.missing = MissingEnd::Least}},
        {"greatest-pixel-missing",
         endQuestion,
         "The pixel of the end with the greater x, of steep lines y, is left out.",
         {.missing = MissingEnd::Greatest}},
        {"rounds-halves-down",
         "Which of two equally near pixels is drawn?",
         "Halves are rounded down, ⌈v − ½⌉ in place of ⌊v + ½⌋. Both pixels are equally near: that "
         "alone is no mistake.",
         {.rounding = AcrossRounding::HalvesDown}},
        {"one-pixel-a-column",
         octantQuestion,
         "Steep lines, too, have one pixel a column: x and y are not exchanged.",
         {.steepPixels = SteepPixels::OneAColumn}},
        {"rows-truncated",
         "To which row does a pixel between two rows belong?",
         "The nearest row is not taken, but the one below; of steep lines the column before.",
         {.rounding = AcrossRounding::Down}},
        {"steep-lines-exchanged",
         octantQuestion,
         "Of steep lines x and y are exchanged, but not again where a pixel is written.",
         {.steepWriting = SteepWriting::Exchanged}},
    };
    return rows;
}

} // namespace pixelplumb
