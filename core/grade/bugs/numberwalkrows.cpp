// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *placesQuestion = "What type does an edge's %3 have while it is stepped?";

std::vector<WalkRow> numberRows()
{
    constexpr auto whole = Truncation::TowardZero;
    return {
        {"whole-slopes",
         walkquestions::division,
         "The slopes of the edges are whole numbers; colours along them are right, and those of a "
         "%1 go from one of its wrong ends to the other.",
         {.slopes = whole}},
        {"whole-edge-colours",
         walkquestions::division,
         "The steps of colour along the edges are whole numbers; their slopes are not.",
         {.edgeColours = whole}},
        {"whole-edge-steps",
         walkquestions::division,
         "The slopes of the edges and the steps of colour along them are whole numbers; the step "
         "of colour along a %1 is not.",
         {.slopes = whole, .edgeColours = whole}},
        {"whole-colours",
         walkquestions::division,
         "All steps of colour are whole numbers, along edges and along a %1; slopes are not.",
         {.edgeColours = whole, .preSteps = whole, .steps = whole}},
        {"whole-increments",
         walkquestions::division,
         "All increments are whole numbers: slopes and steps of colour, along edges and along a "
         "%1.",
         {.slopes = whole, .edgeColours = whole, .preSteps = whole, .steps = whole}},
        {"whole-levels",
         walkquestions::stored,
         "Colours are kept as whole numbers, along edges and along a %1: at each step their "
         "fraction is lost.",
         {.edgeLevels = whole, .levels = whole}},
        {"rounded-slopes",
         walkquestions::division,
         "The slopes of the edges are rounded to the nearest whole numbers; colours along them are "
         "not.",
         {.slopes = Truncation::Nearest}},
        {"whole-edge-levels",
         walkquestions::stored,
         "The colours of an edge are kept as whole numbers: at each %1 their fraction is lost, not "
         "so that of the colours along a %1.",
         {.edgeLevels = whole}},
        {"whole-places",
         placesQuestion,
         "An edge's %3 is kept as a whole number: at each %1 its fraction is lost, not so that of "
         "its colours.",
         {.edgePlaces = whole}},
        {"rounded-places",
         placesQuestion,
         "An edge's %3 is kept as a whole number: at each %1 it is rounded to the nearest, its "
         "colours are not.",
         {.edgePlaces = Truncation::Nearest}},
        {"places-cut-behind-steps",
         placesQuestion,
         "The fraction of an edge's %3 is lost when its slope is added, as by %3 = int(%3 + m) in "
         "Python; that of its first %1 is not, nor those of its colours.",
         {.edgePlaces = whole, .edgeStoring = Storing::BehindSteps}},
        {"places-rounded-behind-steps",
         placesQuestion,
         "An edge's %3 is rounded to the nearest whole number when its slope is added, as by %3 = "
         "round(%3 + m) in Python; that of its first %1 is not, nor are its colours.",
         {.edgePlaces = Truncation::Nearest, .edgeStoring = Storing::BehindSteps}},
    };
}

/// Bounds and colours interpolated in whole numbers, by a product divided by a difference.
std::vector<WalkRow> interpolationRows()
{
    constexpr auto whole = Truncation::TowardZero;
    constexpr auto rounded = Truncation::Nearest;
    constexpr auto added = Storing::Added;
    constexpr const char *places
        = "An edge's %3 is computed in whole numbers, %3₀ + (%3₁ − %3₀)·(%2 − %2₀)/(%2₁ − %2₀); "
          "its colours are not.";
    constexpr const char *edges
        = "The %3 and the colours of an edge are computed in whole numbers, %3₀ + (%3₁ − "
          "%3₀)·(%2 − %2₀)/(%2₁ − %2₀); the colours along a %1 are not.";
    constexpr const char *colours
        = "All colours are computed in whole numbers, R₀ + (R₁ − R₀)·(%2 − %2₀)/(%2₁ − %2₀) along "
          "an edge and likewise along a %1; the %3 of an edge is not.";
    constexpr const char *all
        = "All is computed in whole numbers, %3₀ + (%3₁ − %3₀)·(%2 − %2₀)/(%2₁ − %2₀) and "
          "likewise colours, along edges and along a %1.";
    constexpr const char *question = walkquestions::division;
    return {
        {"whole-interpolated-places",
         question,
         places,
         {.edgePlaces = whole, .edgeStoring = added}},
        {"whole-interpolated-edges",
         question,
         edges,
         {.edgePlaces = whole, .edgeLevels = whole, .edgeStoring = added}},
        {"whole-interpolated-colours",
         question,
         colours,
         {.edgeLevels = whole, .levels = whole, .edgeStoring = added, .spanStoring = added}},
        {"whole-interpolation",
         question,
         all,
         {.edgePlaces = whole,
          .edgeLevels = whole,
          .levels = whole,
          .edgeStoring = added,
          .spanStoring = added}},
        {"rounded-interpolated-places",
         question,
         places,
         {.edgePlaces = rounded, .edgeStoring = added}},
        {"rounded-interpolated-edges",
         question,
         edges,
         {.edgePlaces = rounded, .edgeLevels = rounded, .edgeStoring = added}},
    };
}

} // namespace

const std::vector<WalkRow> &numberWalkRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all = numberRows();
        const std::vector<WalkRow> more = interpolationRows();
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
