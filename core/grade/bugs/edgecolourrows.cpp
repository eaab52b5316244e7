// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *anewQuestion = "With which colour does each %1 begin?";

std::vector<WalkRow> edgeStepRows()
{
    return {
        {"edge-colour-divisor-minus-one",
         walkquestions::edgeDivisor,
         "The colours of an edge are divided by Δ%2 − 1 in place of Δ%2; its slope is not.",
         {.edgeChanges = edgechange::divisorMinusOne, .divided = EdgeRates::Colours}},
        {"edge-colour-divisor-plus-one",
         walkquestions::edgeDivisor,
         "The colours of an edge are divided by Δ%2 + 1 in place of Δ%2; its slope is not.",
         {.edgeChanges = edgechange::divisorPlusOne, .divided = EdgeRates::Colours}},
        {"edge-colours-divided-by-rise",
         walkquestions::edgeDivisor,
         "The colours of an edge are divided by Δ%3 in place of Δ%2; its slope is not. Those of an "
         "edge without a rise are not stepped.",
         {.edgeColourDivisor = EdgeColourDivisor::Rise}},
        {"edge-colours-divided-by-length-of-rise",
         walkquestions::edgeDivisor,
         "The colours of an edge are divided by |Δ%3| in place of Δ%2; its slope is not. Those of "
         "an edge without a rise are not stepped.",
         {.edgeColourDivisor = EdgeColourDivisor::RiseMagnitude}},
        {"edge-colour-steps-negated",
         "Which vertex' colour is subtracted from which?",
         "The steps of colour along all edges have the wrong sign, in the pre-step to an edge's "
         "first %1, too.",
         {.edgeColourSign = EdgeColourSign::Negated}},
        {"rounded-edge-colours",
         walkquestions::division,
         "The steps of colour along the edges are rounded to the nearest whole numbers; their "
         "slopes are not.",
         {.edgeColours = Truncation::Nearest}},
        {"rounded-edge-levels",
         walkquestions::stored,
         "The colours of an edge are kept as whole numbers: at each %1 they are rounded to the "
         "nearest, not so the colours along a %1.",
         {.edgeLevels = Truncation::Nearest}},
        {"rounded-levels",
         walkquestions::stored,
         "Colours are kept as whole numbers, along edges and along a %1: at each step they are "
         "rounded to the nearest.",
         {.edgeLevels = Truncation::Nearest, .levels = Truncation::Nearest}},
        {"edge-levels-cut-behind-steps",
         walkquestions::stored,
         "The fraction of an edge's colour is lost when its step is added, as by r = int(r + dr) "
         "in Python; that of its first %1 is not.",
         {.edgeLevels = Truncation::TowardZero, .edgeStoring = Storing::BehindSteps}},
        {"edge-levels-rounded-behind-steps",
         walkquestions::stored,
         "An edge's colour is rounded to the nearest whole number when its step is added, as by r "
         "= round(r + dr) in Python; that of its first %1 is not.",
         {.edgeLevels = Truncation::Nearest, .edgeStoring = Storing::BehindSteps}},
        {"colours-not-begun-anew",
         anewQuestion,
         "Only the first %1 of a triangle begins with its lower bound's colour: all others go on "
         "from what the %1 before has come to behind its last sample, each by its own step.",
         {.spanStart = SpanStart::GoesOn}},
        {"colours-not-begun-anew-in-a-half",
         anewQuestion,
         "Only the first %1 of each half begins with its lower bound's colour: all others go on "
         "from what the %1 before has come to behind its last sample, each by its own step.",
         {.spanStart = SpanStart::GoesOnInHalf}},
    };
}

/// Mistakes in only some of the channels.
std::vector<WalkRow> edgeChannelRows()
{
    return {
        {"colours-not-stepped-along-edges",
         "How does the colour of an edge change from one %1 to the next?",
         "The colours are not stepped along the edges: they stay what they are at an edge's first "
         "%1.",
         {.unsteppedAlongEdges = allChannels}},
        {"red-not-stepped-along-edges",
         walkquestions::channels,
         "Red is not stepped along the edges: it stays what it is at an edge's first %1.",
         {.unsteppedAlongEdges = redAlone}},
        {"green-not-stepped-along-edges",
         walkquestions::channels,
         "Green is not stepped along the edges: it stays what it is at an edge's first %1.",
         {.unsteppedAlongEdges = greenAlone}},
        {"blue-not-stepped-along-edges",
         walkquestions::channels,
         "Blue is not stepped along the edges: it stays what it is at an edge's first %1.",
         {.unsteppedAlongEdges = blueAlone}},
        {"green-stepped-as-red-along-edges",
         walkquestions::channels,
         "Green is stepped along the edges by the step of red; at an edge's first %1 it is right.",
         {.stepsAlongEdgesOf = ChannelSource::GreenOfRed}},
        {"blue-stepped-as-red-along-edges",
         walkquestions::channels,
         "Blue is stepped along the edges by the step of red; at an edge's first %1 it is right.",
         {.stepsAlongEdgesOf = ChannelSource::BlueOfRed}},
        {"blue-stepped-as-green-along-edges",
         walkquestions::channels,
         "Blue is stepped along the edges by the step of green; at an edge's first %1 it is right.",
         {.stepsAlongEdgesOf = ChannelSource::BlueOfGreen}},
        {"colours-stepped-as-red-along-edges",
         walkquestions::channels,
         "Green and blue are stepped along the edges by the step of red; at an edge's first %1 "
         "they are right.",
         {.stepsAlongEdgesOf = ChannelSource::AllOfRed}},
        {"green-rate-of-red-along-edges",
         walkquestions::channels,
         "Green is stepped along the edges by the step of red, in the pre-step to an edge's first "
         "%1, too.",
         {.ratesAlongEdgesOf = ChannelSource::GreenOfRed}},
        {"blue-rate-of-red-along-edges",
         walkquestions::channels,
         "Blue is stepped along the edges by the step of red, in the pre-step to an edge's first "
         "%1, too.",
         {.ratesAlongEdgesOf = ChannelSource::BlueOfRed}},
        {"blue-rate-of-green-along-edges",
         walkquestions::channels,
         "Blue is stepped along the edges by the step of green, in the pre-step to an edge's first "
         "%1, too.",
         {.ratesAlongEdgesOf = ChannelSource::BlueOfGreen}},
        {"rates-of-red-along-edges",
         walkquestions::channels,
         "Green and blue are stepped along the edges by the step of red, in the pre-step to an "
         "edge's first %1, too.",
         {.ratesAlongEdgesOf = ChannelSource::AllOfRed}},
        {"no-edge-colour-pre-step-of-green",
         walkquestions::channels,
         "Green has no pre-step along the edges: at an edge's first %1 it is its vertex' own. Red "
         "and blue have theirs.",
         {.withoutEdgePreStep = greenAlone}},
        {"no-edge-colour-pre-step-of-blue",
         walkquestions::channels,
         "Blue has no pre-step along the edges: at an edge's first %1 it is its vertex' own. Red "
         "and green have theirs.",
         {.withoutEdgePreStep = blueAlone}},
        {"no-edge-colour-pre-step-but-of-red",
         walkquestions::channels,
         "Of the colours only red has its pre-step along the edges: green and blue are at an "
         "edge's first %1 its vertex' own.",
         {.withoutEdgePreStep = greenAndBlue}},
    };
}

} // namespace

const std::vector<WalkRow> &edgeColourRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all = edgeStepRows();
        const std::vector<WalkRow> ofChannels = edgeChannelRows();
        all.insert(all.end(), ofChannels.begin(), ofChannels.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
