// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *divisorQuestion
    = "What must a difference of colours be divided by to give a step of colour?";
constexpr const char *firstSampleQuestion
    = "How far is it from a bound to the first sample, and in which direction?";
constexpr const char *alongSpanQuestion
    = "How does the colour change from the first sample of a %1 to the last?";

std::vector<WalkRow> colourRows()
{
    return {
        {"whole-colour-steps",
         walkquestions::division,
         "The step of colour along a %1 is a whole number; its first sample is right.",
         {.steps = Truncation::TowardZero}},
        {"whole-colour-rates",
         walkquestions::division,
         "The step of colour along a %1 is a whole number, in the pre-step to its first sample, "
         "too.",
         {.preSteps = Truncation::TowardZero, .steps = Truncation::TowardZero}},
        {"whole-bound-colours",
         walkquestions::stored,
         "The colours of a %1's bounds are cast to whole numbers before it is filled; those of the "
         "edges keep their fractions, and so do those along the %1.",
         {.bounds = Truncation::TowardZero}},
        {"rounded-bound-colours",
         walkquestions::stored,
         "The colours of a %1's bounds are rounded to whole numbers before it is filled; those of "
         "the edges keep their fractions, and so do those along the %1.",
         {.bounds = Truncation::Nearest}},
        {"whole-span-levels",
         walkquestions::stored,
         "The colour along a %1 is kept as a whole number: at each sample its fraction is lost.",
         {.levels = Truncation::TowardZero}},
        {"rounded-colour-rates",
         walkquestions::division,
         "The step of colour along a %1 is rounded to the nearest whole number, in the pre-step to "
         "its first sample, too.",
         {.preSteps = Truncation::Nearest, .steps = Truncation::Nearest}},
        {"rounded-span-levels",
         walkquestions::stored,
         "The colour along a %1 is kept as a whole number: at each sample it is rounded to the "
         "nearest.",
         {.levels = Truncation::Nearest}},
        {"span-levels-cut-behind-steps",
         walkquestions::stored,
         "Along a %1 the fraction of a colour is lost when its step is added, as by r = int(r + "
         "dr) in Python; that of the first sample is not.",
         {.levels = Truncation::TowardZero, .spanStoring = Storing::BehindSteps}},
        {"span-levels-rounded-behind-steps",
         walkquestions::stored,
         "Along a %1 a colour is rounded to the nearest whole number when its step is added, as by "
         "r = round(r + dr) in Python; that of the first sample is not.",
         {.levels = Truncation::Nearest, .spanStoring = Storing::BehindSteps}},
        {"colour-divisor-minus-one",
         divisorQuestion,
         "The step of colour along a %1 is divided by its length less one, not by its length: "
         "where it is shorter than one, by a negative number.",
         {.divisor = SpanDivisor::HeightLessOne}},
        {"colours-of-lower-bound-alone",
         alongSpanQuestion,
         "All samples of a %1 have the colour of its lower bound.",
         {.spanColours = SpanColours::LowerAlone}},
        {"colours-of-upper-bound-alone",
         alongSpanQuestion,
         "All samples of a %1 have the colour of its upper bound.",
         {.spanColours = SpanColours::UpperAlone}},
        {"colours-mean-of-bounds",
         alongSpanQuestion,
         "All samples of a %1 have the mean of the colours of its two bounds.",
         {.spanColours = SpanColours::Mean}},
        {"first-span-levels-cut",
         walkquestions::stored,
         "The colour of a %1's first sample is cast to a whole number; those behind it go on from "
         "there by steps that are not.",
         {.levels = Truncation::TowardZero, .spanStoring = Storing::FirstAlone}},
        {"short-spans-not-stepped",
         divisorQuestion,
         "The step of colour along a %1 is 0 where it is shorter than one: it is divided by its "
         "length only where that is 1 or more.",
         {.divisor = SpanDivisor::HeightFromOne}},
        {"colour-divisor-of-floors",
         divisorQuestion,
         "The step of colour along a %1 is divided by the difference of the whole parts of its two "
         "bounds, as ⌊%4⌋ is one, not by its length: where it is 0, the colour is not stepped.",
         {.divisor = SpanDivisor::HeightOfFloors}},
        {"colour-divisor-plus-one",
         divisorQuestion,
         "The step of colour along a %1 is divided by its length and one, not by its length.",
         {.divisor = SpanDivisor::HeightAndOne}},
        {"colour-divisor-samples",
         divisorQuestion,
         "The step of colour along a %1 is divided by the number of its samples, not by its "
         "length; the pre-step to its first sample is made with it.",
         {.divisor = SpanDivisor::Samples}},
        {"colour-divisor-steps",
         divisorQuestion,
         "The step of colour along a %1 is divided by the number of its samples less one, not by "
         "its length; the pre-step to its first sample is made with it. A single sample has the "
         "lower bound's colour.",
         {.divisor = SpanDivisor::Steps}},
        {"colours-between-samples",
         "Which colour has a bound that lies between two samples, and which the sample beside it?",
         "The first and the last sample of a %1 have the colours of its bounds: the step of colour "
         "is divided by the steps from the one to the other.",
         {.spanPreStep = PreStep::None, .divisor = SpanDivisor::Steps}},
        {"colour-pre-step-of-fraction",
         firstSampleQuestion,
         "The pre-step of colour along a %1 goes by %4 − ⌊%4⌋ in place of ⌈%4⌉ − %4.",
         {.spanPreStep = PreStep::Fraction}},
        {"colour-pre-step-backward",
         firstSampleQuestion,
         "The pre-step of colour along a %1, (⌈%4⌉ − %4)·ΔR, is subtracted, not added.",
         {.spanPreStep = PreStep::Backward}},
        {"colour-pre-step-without-rate",
         firstSampleQuestion,
         "The pre-step of colour along a %1 is the way ⌈%4⌉ − %4 itself, not this times the step "
         "of "
         "colour.",
         {.spanPreStep = PreStep::WithoutRate}},
        {"colours-stepped-first",
         "Which comes first, that a sample is drawn or that its colour is stepped?",
         "The colour along a %1 is stepped before a sample is drawn, not after it: each has the "
         "colour of the next one.",
         {.spanStepping = Stepping::BeforeDrawing}},
        {"colours-of-short-edge-below",
         walkquestions::bounds,
         "Where the long edge is the lower bound of a %1, the bounds are exchanged, but not their "
         "colours: the lower one always has those of the short edge.",
         {.lowerColours = LowerColours::OfShortEdge}},
        {"colours-of-long-edge-below",
         walkquestions::bounds,
         "Where the long edge is the upper bound of a %1, the bounds are exchanged, but not their "
         "colours: the lower one always has those of the long edge.",
         {.lowerColours = LowerColours::OfLongEdge}},
    };
}

/// Mistakes in only some of the channels.
std::vector<WalkRow> channelRows()
{
    return {
        {"colours-not-stepped-along-spans",
         alongSpanQuestion,
         "The colour along a %1 is not stepped: all its samples have that of the first.",
         {.unsteppedAlongSpans = allChannels}},
        {"red-not-stepped-along-spans",
         walkquestions::channels,
         "Red is not stepped along a %1: all its samples have that of the first.",
         {.unsteppedAlongSpans = redAlone}},
        {"green-not-stepped-along-spans",
         walkquestions::channels,
         "Green is not stepped along a %1: all its samples have that of the first.",
         {.unsteppedAlongSpans = greenAlone}},
        {"blue-not-stepped-along-spans",
         walkquestions::channels,
         "Blue is not stepped along a %1: all its samples have that of the first.",
         {.unsteppedAlongSpans = blueAlone}},
        {"green-stepped-as-red",
         walkquestions::channels,
         "Green is stepped along a %1 by the step of red.",
         {.stepsAlongSpansOf = ChannelSource::GreenOfRed}},
        {"blue-stepped-as-red",
         walkquestions::channels,
         "Blue is stepped along a %1 by the step of red.",
         {.stepsAlongSpansOf = ChannelSource::BlueOfRed}},
        {"blue-stepped-as-green",
         walkquestions::channels,
         "Blue is stepped along a %1 by the step of green.",
         {.stepsAlongSpansOf = ChannelSource::BlueOfGreen}},
        {"colours-stepped-as-red",
         walkquestions::channels,
         "Green and blue are stepped along a %1 by the step of red.",
         {.stepsAlongSpansOf = ChannelSource::AllOfRed}},
        {"green-rate-of-red",
         walkquestions::channels,
         "Green is stepped along a %1 by the step of red, in the pre-step to its first sample, "
         "too.",
         {.ratesAlongSpansOf = ChannelSource::GreenOfRed}},
        {"blue-rate-of-red",
         walkquestions::channels,
         "Blue is stepped along a %1 by the step of red, in the pre-step to its first sample, too.",
         {.ratesAlongSpansOf = ChannelSource::BlueOfRed}},
        {"blue-rate-of-green",
         walkquestions::channels,
         "Blue is stepped along a %1 by the step of green, in the pre-step to its first sample, "
         "too.",
         {.ratesAlongSpansOf = ChannelSource::BlueOfGreen}},
        {"rates-of-red",
         walkquestions::channels,
         "Green and blue are stepped along a %1 by the step of red, in the pre-step to its first "
         "sample, too.",
         {.ratesAlongSpansOf = ChannelSource::AllOfRed}},
        {"no-colour-pre-step-of-green",
         walkquestions::channels,
         "Green has no pre-step along a %1: at its first sample it is what it is at the lower "
         "bound. Red and blue have theirs.",
         {.withoutSpanPreStep = greenAlone}},
        {"no-colour-pre-step-of-blue",
         walkquestions::channels,
         "Blue has no pre-step along a %1: at its first sample it is what it is at the lower "
         "bound. Red and green have theirs.",
         {.withoutSpanPreStep = blueAlone}},
        {"no-colour-pre-step-but-of-red",
         walkquestions::channels,
         "Only red has its pre-step along a %1: green and blue are at its first sample what they "
         "are at the lower bound.",
         {.withoutSpanPreStep = greenAndBlue}},
    };
}

} // namespace

const std::vector<WalkRow> &spanColourRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all = colourRows();
        const std::vector<WalkRow> ofChannels = channelRows();
        all.insert(all.end(), ofChannels.begin(), ofChannels.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
