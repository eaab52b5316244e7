// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programlist.h"

namespace pixelplumb {

namespace {

using M = WalkMistake;
using Mistakes = std::set<WalkMistake>;

void addKnown(ProgramList &programs)
{
    programs.addOfEdges("no-edge-pre-step", {M::NoEdgePreStep});
    programs.addOfEdges("colours-without-edge-pre-step", {M::NoEdgeColourPreStep});
    programs.addOfEdges("divisor-minus-one", {M::EdgeDivisorMinusOne});
    programs.addOfEdges("divisor-plus-one", {M::EdgeDivisorPlusOne});
    programs.addOfEdges("unsorted-colours", {M::UnsortedColours});
    programs.addOfEdges("whole-slopes", {M::WholeSlopes});
    programs.addOfEdges("whole-edge-colours", {M::WholeEdgeColours});
    programs.addOfEdges("whole-edge-steps", {M::WholeSlopes, M::WholeEdgeColours});
    programs.addOfEdges("whole-colours", {M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps});
    programs.addOfEdges("whole-increments",
                        {M::WholeSlopes, M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps});
    programs.addOfSpans("whole-colour-steps", {M::WholeSteps});
    programs.addOfSpans("whole-colour-rates", {M::WholePreSteps, M::WholeSteps});
    programs.addOfSpans("colour-divisor-plus-one", {M::SpanDivisorPlusOne});
    programs.addOfSpans("colours-between-samples", {M::ColoursBetweenSamples});
    programs.addOfEnds("last-span-missing", "first-span-missing", {M::LastSpanMissing});
    programs.addOfEnds("first-span-missing", "last-span-missing", {M::FirstSpanMissing});
    programs.addOfEnds("open-at-last-vertex", "open-at-first-vertex", {M::OpenAtLastVertex});
    programs.addOfEnds("open-at-first-vertex", "open-at-last-vertex", {M::OpenAtFirstVertex});
    programs.addOfEnds("middle-span-missing", "middle-floor-span-missing",
                       {M::SecondHalfAfterCeiling});
    programs.addOfEnds("middle-floor-span-missing", "middle-span-missing",
                       {M::FirstHalfTruncated, M::SecondHalfAfterFloor});
    programs.addOfEnds("open-at-middle-vertex", "open-at-middle-vertex", {M::SecondHalfAfterFloor});
    programs.addOfEnds("middle-span-truncated", "middle-span-truncated-from-above",
                       {M::FirstHalfTruncated});
    programs.addOfEnds("first-half-missing", "second-half-behind-middle-missing", {M::NoFirstHalf});
    programs.addOfEnds("second-half-missing", "first-half-and-middle-missing", {M::NoSecondHalf});
    programs.addOfEdges("no-pre-step-behind-middle", {M::NoPreStepOfSecond});
    programs.addOfEdges("loops-truncated", {M::LoopsTruncated});
    programs.addOfEdges("floor-slopes", {M::WholeSlopes, M::DividesDown});
    programs.addOfEdges("floor-edge-colours", {M::WholeEdgeColours, M::DividesDown});
    programs.addOfEdges("floor-edge-steps", {M::WholeSlopes, M::WholeEdgeColours, M::DividesDown});
    programs.addOfEdges("floor-colours",
                        {M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps, M::DividesDown});
    programs.addOfEdges(
        "floor-increments",
        {M::WholeSlopes, M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps, M::DividesDown});
    programs.addOfSpans("floor-colour-steps", {M::WholeSteps, M::DividesDown});
    programs.addOfSpans("floor-colour-rates", {M::WholePreSteps, M::WholeSteps, M::DividesDown});
    programs.addOfSpans("whole-span-levels", {M::WholeSpanLevels});
    programs.addOfSpans("middle-above-lost", {M::LongEdgeAlwaysUpper});
    programs.addOfSpans("middle-below-lost", {M::LongEdgeAlwaysLower});
    programs.addOfEdges("whole-levels", {M::WholeEdgeLevels, M::WholeSpanLevels});
}

void addOfWalks(ProgramList &programs)
{
    programs.addOfSpans("colour-divisor-samples", {M::SpanDivisorSamples});
    programs.addOfSpans("colour-divisor-steps", {M::SpanDivisorSteps});
    programs.addOfSpans("colour-pre-step-of-fraction", {M::SpanPreStepOfFraction});
    programs.addOfSpans("colour-pre-step-backward", {M::SpanPreStepBackward});
    programs.addOfSpans("colours-stepped-first", {M::ColoursSteppedFirst});
    programs.addOfSpans("colours-of-short-edge-below", {M::ShortEdgesColoursBelow});
    programs.addOfSpans("colours-of-long-edge-below", {M::LongEdgesColoursBelow});
    programs.addOfSpans("extra-last-sample", {M::LastSampleTooMany});
    programs.addOfSpans("extra-first-sample", {M::FirstSampleTooMany});
    programs.addOfSpans("extra-first-sample-of-next-colour", {M::FirstSampleTooManyOfNextColour});
    programs.addOfSpans("red-not-stepped-along-spans", {M::RedNotSteppedAlongSpans});
    programs.addOfSpans("green-not-stepped-along-spans", {M::GreenNotSteppedAlongSpans});
    programs.addOfSpans("blue-not-stepped-along-spans", {M::BlueNotSteppedAlongSpans});
    programs.addOfSpans(
        "colours-not-stepped-along-spans",
        {M::RedNotSteppedAlongSpans, M::GreenNotSteppedAlongSpans, M::BlueNotSteppedAlongSpans});
    programs.addOfEdges(
        "colours-not-stepped-along-edges",
        {M::RedNotSteppedAlongEdges, M::GreenNotSteppedAlongEdges, M::BlueNotSteppedAlongEdges});
    programs.addOfSpans("outline-alone", {M::OutlineAlone});
    programs.addOfSpans("edge-along-lost", {M::ReturnsAtFirstVertical, M::ReturnsAtLastVertical});
    programs.addOfEdges("red-not-stepped-along-edges", {M::RedNotSteppedAlongEdges});
    programs.addOfEdges("green-not-stepped-along-edges", {M::GreenNotSteppedAlongEdges});
    programs.addOfEdges("blue-not-stepped-along-edges", {M::BlueNotSteppedAlongEdges});
    programs.addOfEdges("edge-pre-step-of-fraction", {M::EdgePreStepOfFraction});
    programs.addOfEdges("edge-pre-step-backward", {M::EdgePreStepBackward});
    programs.addOfEdges("edges-stepped-first", {M::PlacesSteppedFirst, M::EdgeColoursSteppedFirst});
    programs.addOfEdges("edges-wait-at-empty-spans", {M::EmptySpansContinue});
    programs.addOfEdges("whole-places", {M::WholePlaces});
    programs.addOfEdges("rounded-places", {M::RoundedPlaces});
    programs.addOfEdges("vertices-not-sorted", {M::NotSorted});
    programs.addOfEdges("vertices-sorted-by-the-other", {M::SortedByTheOther});
    programs.addOfEdges("second-edge-of-first-colour", {M::SecondEdgeOfFirstColour});
    programs.addOfEdges("second-edge-carried-on",
                        {M::SecondPlaceCarriedOn, M::SecondColoursCarriedOn});
    programs.addOfEdges("second-edge-place-carried-on", {M::SecondPlaceCarriedOn});
    programs.addOfEdges("second-edge-colours-carried-on", {M::SecondColoursCarriedOn});
    programs.addOfEdges("long-edge-begun-again",
                        {M::LongPlaceBegunAgain, M::LongColoursBegunAgain});
    programs.addOfEdges("long-edge-place-begun-again", {M::LongPlaceBegunAgain});
    programs.addOfEdges("long-edge-colours-begun-again", {M::LongColoursBegunAgain});
    programs.addOfEdges("long-edge-stands", {M::LongPlaceStands, M::LongColoursStand});
    programs.addOfEdges("long-edge-place-stands", {M::LongPlaceStands});
    programs.addOfEdges("long-edge-colours-stand", {M::LongColoursStand});
    programs.addOfEnds("first-edge-along-lost", "last-edge-along-lost",
                       {M::ReturnsAtFirstVertical});
    programs.addOfEnds("last-edge-along-lost", "first-edge-along-lost", {M::ReturnsAtLastVertical});
    programs.addOfEnds("last-edge-along-missing", "first-edge-along-missing",
                       {M::NoSecondHalfAtVertical});
}

void addOfBounds(ProgramList &programs)
{
    programs.addOfSpans("open-at-lower-bound", {M::LowerBoundLeftOut});
    programs.addOfSpans("open-at-upper-bound", {M::UpperBoundLeftOut});
    programs.addOfSpans("open-at-bounds", {M::LowerBoundLeftOut, M::UpperBoundLeftOut});
    programs.addOfSpans("first-sample-nearest", {M::FirstSampleNearest});
    programs.addOfSpans("last-sample-nearest", {M::LastSampleNearest});
    programs.addOfSpans("colours-of-bounds-exchanged", {M::BoundColoursExchanged});
    programs.addOfSpans("whole-bound-colours", {M::WholeBoundColours});
    programs.addOfSpans("rounded-bound-colours", {M::RoundedBoundColours});
    programs.addOfSpans("colours-from-upper-bound", {M::ColoursFromUpperBound});
    programs.addOfSpans("colour-step-negated", {M::ColourStepNegated});
    programs.addOfSpans("colours-from-last-sample", {M::FilledFromLastSample});
    programs.addOfSpans("colour-pre-step-without-rate", {M::SpanPreStepWithoutRate});
    programs.addOfSpans("green-stepped-as-red", {M::GreenSteppedAsRed});
    programs.addOfSpans("blue-stepped-as-red", {M::BlueSteppedAsRed});
    programs.addOfSpans("blue-stepped-as-green", {M::BlueSteppedAsGreen});
    programs.addOfSpans("colours-stepped-as-red", {M::GreenSteppedAsRed, M::BlueSteppedAsRed});
    programs.addOfSpans("sides-by-first-vertex", {M::SidesByFirstVertex});
    programs.addOfSpans("sides-by-last-vertex", {M::SidesByLastVertex});
}

void addOfRates(ProgramList &programs)
{
    programs.addOfEdges("place-without-edge-pre-step", {M::PlaceWithoutPreStep});
    programs.addOfEdges("places-stepped-first", {M::PlacesSteppedFirst});
    programs.addOfEdges("edge-colours-stepped-first", {M::EdgeColoursSteppedFirst});
    programs.addOfEdges("slopes-inverted", {M::SlopesInverted});
    programs.addOfEdges("slopes-negated", {M::SlopesNegated});
    programs.addOfEdges("slopes-of-magnitudes", {M::SlopesOfMagnitudes});
    programs.addOfColumns("sides-by-slopes", {M::SidesBySlopes});
    programs.addOfEdges("rounded-slopes", {M::RoundedSlopes});
    programs.addOfEdges("whole-edge-levels", {M::WholeEdgeLevels});
    programs.addOfEdges("slope-divisor-minus-one", {M::SlopeDivisorMinusOne});
    programs.addOfEdges("slope-divisor-plus-one", {M::SlopeDivisorPlusOne});
    programs.addOfEdges("edge-colour-divisor-minus-one", {M::ColourDivisorMinusOne});
    programs.addOfEdges("edge-colour-divisor-plus-one", {M::ColourDivisorPlusOne});
    programs.addOfEdges("no-pre-step-of-first-edge", {M::NoPreStepOfFirst});
    programs.addOfEdges("no-pre-step-of-long-edge", {M::NoPreStepOfLong});
    programs.addOfEdges("whole-slope-of-first-edge", {M::WholeSlopeOfFirst});
    programs.addOfEdges("whole-slope-of-second-edge", {M::WholeSlopeOfSecond});
    programs.addOfEdges("whole-slope-of-long-edge", {M::WholeSlopeOfLong});
    programs.addOfEdges("slope-of-first-edge-negated", {M::SlopeOfFirstNegated});
    programs.addOfEdges("slope-of-second-edge-negated", {M::SlopeOfSecondNegated});
    programs.addOfEdges("slope-of-long-edge-negated", {M::SlopeOfLongNegated});
    const auto sortedBy = [&](const char *id, Mistakes comparisons) {
        comparisons.insert(M::SortedByComparisons);
        programs.addOfEdges(id, comparisons);
    };
    sortedBy("sorted-by-01", {M::Compares01});
    sortedBy("sorted-by-12", {M::Compares12First});
    sortedBy("sorted-by-02", {M::Compares02});
    sortedBy("sorted-by-01-12", {M::Compares01, M::Compares12Last});
    sortedBy("sorted-by-12-01", {M::Compares12First, M::Compares01});
    sortedBy("sorted-by-01-02", {M::Compares01, M::Compares02});
    sortedBy("sorted-by-02-12", {M::Compares02, M::Compares12Last});
}

void addOfMiddle(ProgramList &programs)
{
    programs.addOfEdges("middle-span-in-both-halves", {M::FirstHalfWithMiddle});
    programs.addOfEdges("second-edge-of-first-place", {M::SecondEdgeOfFirstPlace});
    programs.addOfEdges("second-edge-of-first-slope", {M::SecondSlopeOfFirst});
    programs.addOfEdges("second-edge-of-first-colour-steps", {M::SecondStepsOfFirst});
    programs.addOfEdges("second-edge-of-first-steps", {M::SecondSlopeOfFirst, M::SecondColoursToo});
    programs.addOfEdges("second-half-too-early", {M::SecondHalfTooEarly});
    programs.addOfEdges("second-half-from-nearest", {M::SecondHalfFromNearest});
    programs.addOfEdges("long-edge-begun-again-at-first",
                        {M::LongPlaceBegunAgainAtFirst, M::LongColoursBegunAgainAtFirst});
    programs.addOfEdges("long-edge-place-begun-again-at-first", {M::LongPlaceBegunAgainAtFirst});
    programs.addOfEdges("long-edge-colours-begun-again-at-first",
                        {M::LongColoursBegunAgainAtFirst});
    programs.addOfEdges("long-edge-without-pre-step-behind-middle",
                        {M::LongWithoutPreStepBehindMiddle});
    programs.addOfEdges("long-edge-waits", {M::LongPlaceWaits, M::LongColoursWait});
    programs.addOfEdges("long-edge-place-waits", {M::LongPlaceWaits});
    programs.addOfEdges("long-edge-colours-wait", {M::LongColoursWait});
}

} // namespace

std::vector<MistakenProgram> mistakenPrograms()
{
    ProgramList programs;
    addKnown(programs);
    addOfWalks(programs);
    addOfBounds(programs);
    addOfRates(programs);
    addOfMiddle(programs);
    addOfOtherRates(programs);
    addOfEdgeColours(programs);
    addOfSpanColours(programs);
    return programs.all;
}

} // namespace pixelplumb
