// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/bresenhamdefect.h"

#include "core/grade/bugs/linedecision.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr const char *octantQuestion = "Does it hold in all eight octants?";
constexpr const char *endQuestion = "Is each end's pixel drawn, once?";
constexpr const char *lineColourQuestion
    = "By how much does the colour change from pixel to pixel, and which colour has the first one?";

const std::vector<LineRow> &lineSteps()
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

Defect defectBy(const ProgramLine &program, const QString &id, const char *forStudent,
                const QString &forAssistant)
{
    const auto redraw = [program](const Scene &scene) { return drawnBy(program, scene); };
    return {id, QString::fromUtf8(forStudent), forAssistant, {}, redraw, {}, false, u"lines"_s};
}

Defect defectFrom(LineStart start, const LineRow &row)
{
    const bool fromLeft = start == LineStart::LeastAlong;
    const QString end = fromLeft
        ? u"; steps begin at the end with the lesser x, of steep lines y."_s
        : u"; steps begin at a line's first end."_s;
    ProgramLine program = row.program;
    program.start = start;
    return defectBy(program, (fromLeft ? u"sorted-"_s : QString()) + QString::fromLatin1(row.id),
                    row.forStudent, QString::fromUtf8(row.forAssistant) + end);
}

/// Loops that only go up along the line: what happens to lines that are not sorted so.
void appendDescending(std::vector<Defect> &defects)
{
    struct Sorting {
        const char *id;
        const char *lines;
        LineStart start;
    };
    constexpr std::array sortings = {
        Sorting{"descending-lines",
                "Lines whose second end is left of the first, of steep lines below it, ",
                LineStart::FirstEnd},
        Sorting{"steep-falling-lines",
                "Steep lines that fall from left to right, for their ends are sorted by x, ",
                LineStart::LeastX},
        Sorting{
            "flat-backward-lines",
            "Flat lines whose second end is left of the first, for steep ones alone are sorted, ",
            LineStart::LeastYOfSteep},
        Sorting{"steep-descending-lines",
                "Steep lines whose second end is below the first, for flat ones alone are sorted, ",
                LineStart::LeastXOfFlat},
    };
    struct Fate {
        const char *id;
        const char *words;
        DescendingLine descending;
    };
    constexpr std::array fates = {
        Fate{"-lost", "are not drawn: the loop goes upward alone.", DescendingLine::Lost},
        Fate{"-of-one-pixel", "are their first pixel alone: the loop goes upward alone.",
             DescendingLine::FirstPixelAlone},
        Fate{"-ascend", "are drawn upward from there: the loop goes upward alone.",
             DescendingLine::Ascends},
    };
    for (const Sorting &sorting : sortings) {
        for (const Fate &fate : fates) {
            Defect defect = defectBy(
                {.start = sorting.start, .descending = fate.descending},
                QString::fromLatin1(sorting.id) + QString::fromLatin1(fate.id), octantQuestion,
                QString::fromUtf8(sorting.lines) + QString::fromUtf8(fate.words));
            // Combined with a scene's defect of such lines it would act on all lines.
            if (sorting.start != LineStart::FirstEnd)
                defect.choice = QString::fromLatin1(lineEndsChoice);
            defects.push_back(std::move(defect));
        }
    }
}

} // namespace

std::vector<Defect> bresenhamDefects()
{
    std::vector<Defect> defects;
    const auto add = [&](const LineRow &row) {
        defects.push_back(defectFrom(LineStart::FirstEnd, row));
        defects.push_back(defectFrom(LineStart::LeastAlong, row));
    };
    std::ranges::for_each(decisionBeginnings(), add);
    std::ranges::for_each(decisionSteps(), add);
    std::ranges::for_each(lineSteps(), add);
    appendDescending(defects);
    defects.push_back(
        defectBy({.start = LineStart::FirstEnd,
                  .descending = DescendingLine::Lost,
                  .across = AcrossStep::NoneDownward,
                  .steep = SteepLine::AsFlat},
                 u"first-octant-unsorted"_s, octantQuestion,
                 u"The steps are those of the first octant: lines whose second end is "
                 "left of the first are not drawn, steep ones step across at each step, "
                 "falling ones stay in their first row."_s));
    // From a line's first end this would be steep-lines-as-flat.
    defects.push_back(
        defectBy({.start = LineStart::LeastAlong, .steep = SteepLine::OwnDifferences},
                 u"sorted-steep-lines-by-own-differences"_s, octantQuestion,
                 u"Of steep lines x and y are exchanged, Δx and Δy are not: from the end with "
                 "the lesser y they step across at each step, only Δx times."_s));
    // From a line's first end these would be a scene's defect of all methods.
    defects.push_back(
        defectBy({.start = LineStart::LeastAlong, .across = AcrossStep::NoneDownward},
                 u"sorted-falling-lines-level"_s, octantQuestion,
                 u"Lines that fall from left to right stay in their first row, steep ones "
                 "that go up and to the left in their first column: Δy is negative, and so "
                 "is p."_s));
    defects.push_back(defectBy({.start = LineStart::LeastAlong, .colours = LineColours::OfStart},
                               u"lines-of-left-colour"_s, lineColourQuestion,
                               u"A line has the colour of the end with the lesser x, "
                               "of steep lines y, alone."_s));
    defects.push_back(defectBy({.start = LineStart::LeastAlong, .colours = LineColours::AsGiven},
                               u"line-colours-not-sorted"_s, lineColourQuestion,
                               u"The ends are sorted by x, of steep lines by y, and "
                               "their colours are not."_s));
    return defects;
}

} // namespace pixelplumb
