// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *boundEndsQuestion
    = "From which to which sample does a span go? What if its bound lies "
      "between two?";
constexpr const char *divisorQuestion
    = "By what is a difference of colours divided to have a step of colour?";
constexpr const char *firstSampleQuestion
    = "How far is it from a bound to the first sample, and in which direction?";
constexpr const char *boundsQuestion
    = "Which bound of a %1 has which colour? Whichever edge is the lower one?";
constexpr const char *upperQuestion = "Which of the two edges is the upper bound? Always?";
constexpr const char *countQuestion = "How many samples has a %1? What if it has none?";

std::vector<WalkRow> endRows()
{
    constexpr auto down = EndRounding::Down;
    constexpr auto up = EndRounding::Up;
    return {
        {"ends-truncated",
         boundEndsQuestion,
         "Both bounds of a %1 are cast to whole numbers: ⌊ ⌋ of both.",
         {.first = down, .last = down}},
        {"ends-truncated-wrapping",
         boundEndsQuestion,
         "Both bounds of a %1 are cast to whole numbers, and levels beyond 0 … 255, which come "
         "from that, wrap.",
         {.first = down, .last = down},
         LevelOverflow::Wraps},
        {"ends-nearest",
         boundEndsQuestion,
         "Both bounds of a %1 are rounded to the nearest.",
         {.first = EndRounding::Nearest, .last = EndRounding::Nearest}},
        {"first-sample-nearest",
         boundEndsQuestion,
         "The lower bound of a %1 is rounded to the nearest sample; its upper one is right.",
         {.first = EndRounding::Nearest}},
        {"last-sample-nearest",
         boundEndsQuestion,
         "The upper bound of a %1 is rounded to the nearest sample; its lower one is right.",
         {.last = EndRounding::Nearest}},
        {"ends-outward",
         boundEndsQuestion,
         "A %1 goes from ⌊ ⌋ of its lower bound to ⌈ ⌉ of its upper one.",
         {.first = down, .last = up}},
        {"ends-upward",
         boundEndsQuestion,
         "A %1 goes from ⌈ ⌉ of its lower bound to ⌈ ⌉ of its upper one.",
         {.first = up, .last = up}},
        {"extra-last-sample",
         countQuestion,
         "Each %1 has a sample too many, behind its last one, even one that has none.",
         {.extraBehind = 1}},
        {"extra-first-sample",
         countQuestion,
         "Each %1 begins a sample too early, at ⌈%4⌉ − 1, even one that has none; the pre-step of "
         "colour goes to that sample.",
         {.extraBefore = 1}},
        {"extra-first-sample-of-next-colour",
         countQuestion,
         "Each %1 begins a sample too early, at ⌈%4⌉ − 1, even one that has none, with the colour "
         "that belongs to ⌈%4⌉: all its colours are a sample too early.",
         {.spanStepping = Stepping::BeforeDrawing, .extraBefore = 1}},
    };
}

std::vector<WalkRow> colourRows()
{
    return {
        {"whole-colour-steps",
         walkquestions::division,
         "The step of colour along a %1 is a whole number; its first sample is right.",
         {.steps = Kept::TowardZero}},
        {"whole-colour-rates",
         walkquestions::division,
         "The step of colour along a %1 is a whole number, in the pre-step to its first sample, "
         "too.",
         {.preSteps = Kept::TowardZero, .steps = Kept::TowardZero}},
        {"whole-bound-colours",
         walkquestions::stored,
         "The colours of a %1's bounds are cast to whole numbers before it is filled; those of the "
         "edges keep their fractions, and so do those along the %1.",
         {.bounds = Kept::TowardZero}},
        {"rounded-bound-colours",
         walkquestions::stored,
         "The colours of a %1's bounds are rounded to whole numbers before it is filled; those of "
         "the edges keep their fractions, and so do those along the %1.",
         {.bounds = Kept::Nearest}},
        {"whole-span-levels",
         walkquestions::stored,
         "The colour along a %1 is kept as a whole number: at each sample its fraction is lost.",
         {.levels = Kept::TowardZero}},
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
         "The colour along a %1 is stepped before a sample is drawn, not behind it: each has the "
         "colour of the next one.",
         {.spanStepping = Stepping::BeforeDrawing}},
        {"colours-of-short-edge-below",
         boundsQuestion,
         "Where the long edge is the lower bound of a %1, the bounds are exchanged, but not their "
         "colours: the lower one always has those of the short edge.",
         {.lowerColours = LowerColours::OfShortEdge}},
        {"colours-of-long-edge-below",
         boundsQuestion,
         "Where the long edge is the upper bound of a %1, the bounds are exchanged, but not their "
         "colours: the lower one always has those of the long edge.",
         {.lowerColours = LowerColours::OfLongEdge}},
        {"colours-not-stepped-along-spans",
         "How does the colour change from the first sample of a %1 to the last?",
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
    };
}

std::vector<WalkRow> boundRows()
{
    return {
        {"colours-of-bounds-exchanged",
         boundsQuestion,
         "The colours of the two bounds are exchanged: a %1 goes from the upper bound's colour at "
         "its lower bound to the lower bound's at its upper one.",
         {.lowerColours = LowerColours::OfUpperEdge}},
        {"colours-from-upper-bound",
         boundsQuestion,
         "A %1 begins at its lower bound with the upper bound's colour, and is stepped by the "
         "right "
         "step.",
         {.spanColours = SpanColours::FromUpperBound}},
        {"colour-step-negated",
         "Which bound's colour is subtracted from which? And %4 from what?",
         "The step of colour along a %1 has the wrong sign, in the pre-step to its first sample, "
         "too.",
         {.spanColours = SpanColours::Falling}},
        {"colours-from-last-sample",
         "From which end is a %1 filled? Which bound's colour does it begin with there?",
         "A %1 is filled from its last sample to its first, with the colours that go from its "
         "first to its last.",
         {.spanColours = SpanColours::FromLastSample}},
        {"green-stepped-as-red",
         walkquestions::channels,
         "Green is stepped along a %1 by the step of red.",
         {.stepsAlongSpansOf = {0, 0, 2}}},
        {"blue-stepped-as-red",
         walkquestions::channels,
         "Blue is stepped along a %1 by the step of red.",
         {.stepsAlongSpansOf = {0, 1, 0}}},
        {"blue-stepped-as-green",
         walkquestions::channels,
         "Blue is stepped along a %1 by the step of green.",
         {.stepsAlongSpansOf = {0, 1, 1}}},
        {"colours-stepped-as-red",
         walkquestions::channels,
         "Green and blue are stepped along a %1 by the step of red.",
         {.stepsAlongSpansOf = {0, 0, 0}}},
        {"middle-above-lost",
         upperQuestion,
         "The long edge is always taken for the upper bound of a %1: triangles whose middle "
         "vertex lies beyond it are not drawn, but for a tip on a sample.",
         {.upperEdge = UpperEdge::Long}},
        {"middle-below-lost",
         upperQuestion,
         "The long edge is always taken for the lower bound of a %1: triangles whose middle "
         "vertex lies before it are not drawn, but for a tip on a sample.",
         {.upperEdge = UpperEdge::Short}},
        {"sides-by-first-vertex",
         upperQuestion,
         "The long edge is taken for the upper bound of a %1 where %3₁ < %3₀, not where the middle "
         "vertex lies before it: triangles of which that is not the same are not drawn, but for a "
         "tip on a sample.",
         {.upperEdge = UpperEdge::LongIfBelowFirst}},
        {"sides-by-last-vertex",
         upperQuestion,
         "The long edge is taken for the upper bound of a %1 where %3₁ < %3₂, not where the middle "
         "vertex lies before it: triangles of which that is not the same are not drawn, but for a "
         "tip on a sample.",
         {.upperEdge = UpperEdge::LongIfBelowLast}},
    };
}

} // namespace

const std::vector<WalkRow> &spanWalkRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all;
        for (const std::vector<WalkRow> &some : {endRows(), colourRows(), boundRows()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
