// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkrows.h"

namespace pixelplumb {

namespace {

constexpr auto ofFirstEdge = RateOf::FirstEdge;
constexpr auto ofLongRise = RateOf::LongRise;
constexpr auto ofLongRun = RateOf::LongRun;

std::vector<WalkRow> secondRateRows()
{
    return {
        {"second-edge-of-first-slope",
         walkquestions::middle,
         "The edge from the middle vertex to the last has the slope of the edge before it; its "
         "colours are stepped by their own steps.",
         {.secondSlope = ofFirstEdge}},
        {"second-edge-of-first-colour-steps",
         walkquestions::middle,
         "The colours of the edge from the middle vertex to the last are stepped by the steps of "
         "the edge before it; its slope is its own.",
         {.secondColourRates = ofFirstEdge}},
        {"second-edge-of-first-steps",
         walkquestions::middle,
         "The edge from the middle vertex to the last begins there, but is stepped by the slope "
         "and the steps of colour of the edge before it.",
         {.secondSlope = ofFirstEdge, .secondColourRates = ofFirstEdge}},
        {"second-edge-slope-of-long-rise",
         walkquestions::differences,
         "The slope of the edge from the middle vertex to the last is (%3₂ − %3₀)/(%2₂ − %2₁): its "
         "rise is from the first vertex.",
         {.secondSlope = ofLongRise}},
        {"second-edge-slope-of-long-run",
         walkquestions::differences,
         "The slope of the edge from the middle vertex to the last is (%3₂ − %3₁)/(%2₂ − %2₀): its "
         "run is from the first vertex.",
         {.secondSlope = ofLongRun}},
        {"second-edge-steps-of-long-rise",
         walkquestions::differences,
         "Slope and steps of colour of the edge from the middle vertex to the last are differences "
         "from the first vertex, divided by %2₂ − %2₁.",
         {.secondSlope = ofLongRise, .secondColourRates = ofLongRise}},
        {"second-edge-steps-of-long-run",
         walkquestions::differences,
         "Slope and steps of colour of the edge from the middle vertex to the last are divided by "
         "%2₂ − %2₀ in place of %2₂ − %2₁.",
         {.secondSlope = ofLongRun, .secondColourRates = ofLongRun}},
        {"second-edge-colour-steps-of-long-rise",
         walkquestions::differences,
         "The steps of colour of the edge from the middle vertex to the last are differences from "
         "the first vertex' colour, divided by %2₂ − %2₁; its slope is right.",
         {.secondColourRates = ofLongRise}},
        {"second-edge-colour-steps-of-long-run",
         walkquestions::differences,
         "The steps of colour of the edge from the middle vertex to the last are divided by %2₂ − "
         "%2₀ in place of %2₂ − %2₁; its slope is right.",
         {.secondColourRates = ofLongRun}},
        {"second-edge-of-long-colour-steps",
         walkquestions::differences,
         "The colours of the edge from the middle vertex to the last are stepped by the steps of "
         "the long edge; its slope is right.",
         {.secondColourRates = RateOf::LongEdge}},
    };
}

std::vector<WalkRow> firstRateRows()
{
    return {
        {"first-edge-of-long-colour-steps",
         walkquestions::differences,
         "The colours of the edge from the first vertex to the middle one are stepped by the steps "
         "of the long edge; its slope is right.",
         {.firstColourRates = RateOf::LongEdge}},
        {"first-edge-colour-steps-of-long-rise",
         walkquestions::differences,
         "The steps of colour of the edge from the first vertex to the middle one are differences "
         "to the last vertex' colour, divided by %2₁ − %2₀; its slope is right.",
         {.firstColourRates = ofLongRise}},
        {"first-edge-colour-steps-of-long-run",
         walkquestions::differences,
         "The steps of colour of the edge from the first vertex to the middle one are divided by "
         "%2₂ − %2₀ in place of %2₁ − %2₀; its slope is right.",
         {.firstColourRates = ofLongRun}},
        {"first-edge-slope-of-long-rise",
         walkquestions::differences,
         "The slope of the edge from the first vertex to the middle one is (%3₂ − %3₀)/(%2₁ − "
         "%2₀): its rise is to the last vertex.",
         {.firstSlope = ofLongRise}},
        {"first-edge-slope-of-long-run",
         walkquestions::differences,
         "The slope of the edge from the first vertex to the middle one is (%3₁ − %3₀)/(%2₂ − "
         "%2₀): its run is to the last vertex.",
         {.firstSlope = ofLongRun}},
        {"first-edge-steps-of-long-run",
         walkquestions::differences,
         "Slope and steps of colour of the edge from the first vertex to the middle one are "
         "divided by %2₂ − %2₀ in place of %2₁ − %2₀.",
         {.firstSlope = ofLongRun, .firstColourRates = ofLongRun}},
    };
}

std::vector<WalkRow> longRateRows()
{
    constexpr auto firstRise = RateOf::FirstRise;
    constexpr auto firstRun = RateOf::FirstRun;
    return {
        {"long-edge-of-first-colour-steps",
         walkquestions::differences,
         "The colours of the long edge are stepped by the steps of the edge from the first vertex "
         "to the middle one; its slope is right.",
         {.longColourRates = ofFirstEdge}},
        {"long-edge-colour-steps-of-first-rise",
         walkquestions::differences,
         "The steps of colour of the long edge are differences to the middle vertex' colour, "
         "divided by %2₂ − %2₀; its slope is right.",
         {.longColourRates = firstRise}},
        {"long-edge-colour-steps-of-first-run",
         walkquestions::differences,
         "The steps of colour of the long edge are divided by %2₁ − %2₀ in place of %2₂ − %2₀; its "
         "slope is right.",
         {.longColourRates = firstRun}},
        {"long-edge-slope-of-first-rise",
         walkquestions::differences,
         "The slope of the long edge is (%3₁ − %3₀)/(%2₂ − %2₀): its rise is to the middle vertex.",
         {.longSlope = firstRise}},
        {"long-edge-slope-of-first-run",
         walkquestions::differences,
         "The slope of the long edge is (%3₂ − %3₀)/(%2₁ − %2₀): its run is to the middle vertex.",
         {.longSlope = firstRun}},
        {"long-edge-steps-of-first-run",
         walkquestions::differences,
         "Slope and steps of colour of the long edge are divided by %2₁ − %2₀ in place of %2₂ − "
         "%2₀.",
         {.longSlope = firstRun, .longColourRates = firstRun}},
    };
}

/// An edge along a span lends another edge the slope 0.
std::vector<WalkRow> exchangedRows()
{
    return {
        {"slopes-of-short-edges-exchanged",
         walkquestions::differences,
         "The slopes of the two short edges are exchanged: each has the other's; the colours are "
         "stepped by their own steps.",
         {.slopesOf = SlopeExchange::OfShort}},
        {"slopes-of-first-and-long-edge-exchanged",
         walkquestions::differences,
         "The slopes of the edge from the first vertex to the middle one and of the long edge are "
         "exchanged: each has the other's; the colours are stepped by their own steps.",
         {.slopesOf = SlopeExchange::OfFirstAndLong}},
        {"slopes-of-second-and-long-edge-exchanged",
         walkquestions::differences,
         "The slopes of the edge from the middle vertex to the last and of the long edge are "
         "exchanged: each has the other's; the colours are stepped by their own steps.",
         {.slopesOf = SlopeExchange::OfSecondAndLong}},
    };
}

} // namespace

const std::vector<WalkRow> &mistakenRateRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all;
        for (const std::vector<WalkRow> &some :
             {firstRateRows(), secondRateRows(), longRateRows(), exchangedRows()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
