// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/linedecision.h"

namespace pixelplumb {

namespace {

constexpr const char *beginQuestion = "How much has the line risen half-way to the next column?";
constexpr const char *stepQuestion
    = "By how much does p change where the line stays in its row, and where it steps out of it?";
constexpr const char *orderQuestion = "When is p tested, changed and reset?";

constexpr std::int64_t twiceRise(std::int64_t, std::int64_t dy) { return 2 * dy; }
constexpr std::int64_t twiceDifference(std::int64_t dx, std::int64_t dy) { return 2 * dy - 2 * dx; }
constexpr std::int64_t midpoint(std::int64_t dx, std::int64_t dy) { return 2 * dy - dx; }
constexpr std::int64_t difference(std::int64_t dx, std::int64_t dy) { return dy - dx; }
constexpr std::int64_t rise(std::int64_t, std::int64_t dy) { return dy; }
constexpr std::int64_t nothing(std::int64_t, std::int64_t) { return 0; }

} // namespace

const std::vector<LineRow> &decisionBeginnings()
{
    static const std::vector<LineRow> rows = {
        {"decision-without-dx",
         beginQuestion,
         "The decision begins with 2Δy in place of 2Δy − Δx",
         {{.first = twiceRise}}},
        {"decision-from-difference",
         beginQuestion,
         "The decision begins with Δy − Δx in place of 2Δy − Δx",
         {{.first = difference}}},
        {"decision-from-twice-difference",
         beginQuestion,
         "The decision begins with 2Δy − 2Δx in place of 2Δy − Δx",
         {{.first = twiceDifference}}},
        {"decision-from-rise",
         beginQuestion,
         "The decision begins with Δy in place of 2Δy − Δx",
         {{.first = rise}}},
        {"decision-from-zero",
         beginQuestion,
         "The decision begins with 0 in place of 2Δy − Δx",
         {{.first = nothing}}},
        {"decision-without-dy",
         beginQuestion,
         "The decision begins with −Δx in place of 2Δy − Δx",
         {{.first = [](std::int64_t dx, std::int64_t) { return -dx; }}}},
        {"decision-from-sum",
         beginQuestion,
         "The decision begins with 2Δy + Δx in place of 2Δy − Δx",
         {{.first = [](std::int64_t dx, std::int64_t dy) { return 2 * dy + dx; }}}},
        {"decision-from-negated",
         beginQuestion,
         "The decision begins with Δx − 2Δy in place of 2Δy − Δx",
         {{.first = [](std::int64_t dx, std::int64_t dy) { return dx - 2 * dy; }}}},
        {"decision-from-half",
         beginQuestion,
         "The decision begins with Δy − Δx/2, which is half of 2Δy − Δx, and what is added is not "
         "halved",
         {{.first = [](std::int64_t dx, std::int64_t dy) { return dy - dx / 2; }}}},
        {"decision-of-exchanged-differences",
         beginQuestion,
         "The decision begins with 2Δx − Δy in place of 2Δy − Δx",
         {{.first = [](std::int64_t dx, std::int64_t dy) { return 2 * dx - dy; }}}},
    };
    return rows;
}

const std::vector<LineRow> &decisionSteps()
{
    static const std::vector<LineRow> rows = {
        {"decision-stays-by-dy",
         stepQuestion,
         "Where the line stays, Δy is added to p in place of 2Δy",
         {{.stay = rise}}},
        {"decision-stays-by-dx",
         stepQuestion,
         "Where the line stays, 2Δx is added to p in place of 2Δy",
         {{.stay = [](std::int64_t dx, std::int64_t) { return 2 * dx; }}}},
        {"decision-stays-unchanged",
         stepQuestion,
         "Where the line stays, nothing is added to p in place of 2Δy: it stays to its end",
         {{.stay = nothing}}},
        {"decision-crosses-by-dx",
         stepQuestion,
         "Where the line steps across, 2Δy − Δx is added to p in place of 2Δy − 2Δx",
         {{.cross = midpoint}}},
        {"decision-crosses-by-difference",
         stepQuestion,
         "Where the line steps across, Δy − Δx is added to p in place of 2Δy − 2Δx",
         {{.cross = difference}}},
        {"decision-steps-halved",
         stepQuestion,
         "Δy and Δy − Δx are added to p in place of 2Δy and 2Δy − 2Δx",
         {{.stay = rise, .cross = difference}}},
        {"decision-never-lowered",
         stepQuestion,
         "Where the line steps across, p is not lowered below 0, as by 2Δy alone: from its first "
         "step across on the line steps across always",
         {{.cross = twiceRise}}},
        {"decision-lowered-alone",
         stepQuestion,
         "Where the line steps across, 2Δx is subtracted from p, but 2Δy is not added",
         {{.cross = [](std::int64_t dx, std::int64_t) { return -2 * dx; }}}},
        {"decision-lowered-by-dx",
         stepQuestion,
         "Where the line steps across, Δx is subtracted from p, and 2Δy is not added",
         {{.cross = [](std::int64_t dx, std::int64_t) { return -dx; }}}},
        {"decision-steps-exchanged",
         stepQuestion,
         "2Δy − 2Δx is added to p where the line stays, 2Δy where it steps across",
         {{.stay = twiceDifference, .cross = twiceRise}}},
        {"decision-of-wrong-sign",
         stepQuestion,
         "The line steps across where p < 0, and stays where it is not",
         {{.steps = StepsAcross::WhereNegative}}},
        {"decision-stepped-twice",
         orderQuestion,
         "2Δy is added to p always; where the line steps across 2Δy − 2Δx is added beside it",
         {{.update = DecisionUpdate::AddsAlways}}},
        {"decision-stepped-before-test",
         orderQuestion,
         "2Δy is added to p before it is asked, not after it",
         {{.update = DecisionUpdate::BeforeTest}}},
        {"decision-set-back",
         orderQuestion,
         "Where the line steps across, p is set to 2Δy − Δx again",
         {{.update = DecisionUpdate::SetBack}}},
        {"decision-of-line-before",
         orderQuestion,
         "A line begins with the p that the line before ended with: it is not set anew",
         {{.start = DecisionStart::OfLineBefore}}},
        {"line-slope-whole",
         "What does a division of two whole numbers give you?",
         "The slope Δy/Δx is a whole number, 0 but where Δy is Δx: other lines stay in their first "
         "row, steep ones in their first column",
         {{.first
           = [](std::int64_t dx, std::int64_t dy) { return std::int64_t(dy == dx ? 1 : -1); },
           .stay = nothing,
           .cross = nothing}}},
    };
    return rows;
}

} // namespace pixelplumb
