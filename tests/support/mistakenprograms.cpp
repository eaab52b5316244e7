// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/mistakenprograms.h"

namespace pixelplumb {

namespace {

using M = WalkMistake;
using Mistakes = std::set<WalkMistake>;

class Programs {
public:
    /// Mistakes that go by columns and, from either end, by rows.
    void addOfEdges(const char *id, Mistakes mistakes)
    {
        add(id, mistakes, "column-scan");
        add(id, mistakes, "row-walk");
        mistakes.insert(M::FromBelow);
        add(qPrintable(QString::fromLatin1(id) + QStringLiteral("-from-below")), mistakes,
            "row-walk");
    }
    /// Of spans, where it does not matter from which end they are gone through.
    void addOfSpans(const char *id, const Mistakes &mistakes)
    {
        add(id, mistakes, "column-scan");
        add(id, mistakes, "row-walk");
    }
    /// From above the last row is that of the least y.
    void addOfEnds(const char *id, const char *fromAbove, Mistakes mistakes)
    {
        add(id, mistakes, "column-scan");
        add(fromAbove, mistakes, "row-walk");
        mistakes.insert(M::FromBelow);
        add(id, mistakes, "row-walk");
    }

    std::vector<MistakenProgram> all;

private:
    void add(const char *id, const Mistakes &mistakes, const char *method)
    {
        all.push_back({QString::fromLatin1(method), QString::fromLatin1(id), mistakes});
    }
};

void addKnown(Programs &programs)
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

void addOfWalks(Programs &programs)
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

void addOfBounds(Programs &programs)
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

void addOfRates(Programs &programs)
{
    programs.addOfEdges("place-without-edge-pre-step", {M::PlaceWithoutPreStep});
    programs.addOfEdges("places-stepped-first", {M::PlacesSteppedFirst});
    programs.addOfEdges("edge-colours-stepped-first", {M::EdgeColoursSteppedFirst});
    programs.addOfEdges("slopes-inverted", {M::SlopesInverted});
    programs.addOfEdges("slopes-negated", {M::SlopesNegated});
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

void addOfMiddle(Programs &programs)
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
    programs.addOfEdges("long-edge-waits", {M::LongPlaceWaits, M::LongColoursWait});
    programs.addOfEdges("long-edge-place-waits", {M::LongPlaceWaits});
    programs.addOfEdges("long-edge-colours-wait", {M::LongColoursWait});
}

void addOfOtherRates(Programs &programs)
{
    programs.addOfEdges("second-edge-slope-of-long-rise", {M::OtherRiseOfSecond});
    programs.addOfEdges("second-edge-slope-of-long-run", {M::OtherRunOfSecond});
    programs.addOfEdges("second-edge-steps-of-long-rise",
                        {M::OtherRiseOfSecond, M::OtherColoursOfSecond});
    programs.addOfEdges("second-edge-steps-of-long-run",
                        {M::OtherRunOfSecond, M::OtherColourRunOfSecond});
    programs.addOfEdges("second-edge-colour-steps-of-long-rise", {M::OtherColoursOfSecond});
    programs.addOfEdges("second-edge-colour-steps-of-long-run", {M::OtherColourRunOfSecond});
    programs.addOfEdges("second-edge-of-long-colour-steps",
                        {M::OtherColoursOfSecond, M::OtherColourRunOfSecond});
    programs.addOfEdges("first-edge-of-long-colour-steps",
                        {M::OtherColoursOfFirst, M::OtherColourRunOfFirst});
    programs.addOfEdges("first-edge-colour-steps-of-long-rise", {M::OtherColoursOfFirst});
    programs.addOfEdges("first-edge-colour-steps-of-long-run", {M::OtherColourRunOfFirst});
    programs.addOfEdges("first-edge-slope-of-long-rise", {M::OtherRiseOfFirst});
    programs.addOfEdges("first-edge-slope-of-long-run", {M::OtherRunOfFirst});
    programs.addOfEdges("first-edge-steps-of-long-run",
                        {M::OtherRunOfFirst, M::OtherColourRunOfFirst});
    programs.addOfEdges("long-edge-of-first-colour-steps",
                        {M::OtherColoursOfLong, M::OtherColourRunOfLong});
    programs.addOfEdges("long-edge-colour-steps-of-first-rise", {M::OtherColoursOfLong});
    programs.addOfEdges("long-edge-colour-steps-of-first-run", {M::OtherColourRunOfLong});
    programs.addOfEdges("long-edge-slope-of-first-rise", {M::OtherRiseOfLong});
    programs.addOfEdges("long-edge-slope-of-first-run", {M::OtherRunOfLong});
    programs.addOfEdges("long-edge-steps-of-first-run",
                        {M::OtherRunOfLong, M::OtherColourRunOfLong});
}

void addOfEdgeColours(Programs &programs)
{
    programs.addOfEdges("edge-colours-divided-by-rise", {M::EdgeColoursByRise});
    programs.addOfEdges("edge-colours-divided-by-length-of-rise", {M::EdgeColoursByLengthOfRise});
    programs.addOfEdges("edge-colour-steps-negated", {M::EdgeColoursNegated});
    programs.addOfEdges("rounded-edge-colours", {M::RoundedEdgeColours});
    programs.addOfEdges("rounded-edge-levels", {M::RoundedEdgeLevels});
    programs.addOfEdges("rounded-levels", {M::RoundedEdgeLevels, M::RoundedSpanLevels});
    programs.addOfEdges("edge-levels-cut-behind-steps", {M::EdgeLevelsCutBehindSteps});
    programs.addOfEdges("edge-levels-rounded-behind-steps", {M::EdgeLevelsRoundedBehindSteps});
    programs.addOfEdges("places-cut-behind-steps", {M::PlacesCutBehindSteps});
    programs.addOfEdges("places-rounded-behind-steps", {M::PlacesRoundedBehindSteps});
    programs.addOfEdges("runs-of-whole-ends", {M::RunsOfWholeEnds});
    programs.addOfEdges("colours-not-begun-anew", {M::ColoursGoOn});
    programs.addOfEdges("colours-not-begun-anew-in-a-half", {M::ColoursGoOnInHalf});
    programs.addOfEdges("green-rate-of-red-along-edges", {M::GreenRateOfRedAlongEdges});
    programs.addOfEdges("blue-rate-of-red-along-edges", {M::BlueRateOfRedAlongEdges});
    programs.addOfEdges("blue-rate-of-green-along-edges", {M::BlueRateOfGreenAlongEdges});
    programs.addOfEdges("rates-of-red-along-edges",
                        {M::GreenRateOfRedAlongEdges, M::BlueRateOfRedAlongEdges});
    programs.addOfEdges("green-stepped-as-red-along-edges", {M::GreenSteppedAsRedAlongEdges});
    programs.addOfEdges("blue-stepped-as-red-along-edges", {M::BlueSteppedAsRedAlongEdges});
    programs.addOfEdges("blue-stepped-as-green-along-edges", {M::BlueSteppedAsGreenAlongEdges});
    programs.addOfEdges("colours-stepped-as-red-along-edges",
                        {M::GreenSteppedAsRedAlongEdges, M::BlueSteppedAsRedAlongEdges});
    programs.addOfEdges("no-edge-colour-pre-step-of-green", {M::GreenWithoutEdgePreStep});
    programs.addOfEdges("no-edge-colour-pre-step-of-blue", {M::BlueWithoutEdgePreStep});
    programs.addOfEdges("no-edge-colour-pre-step-but-of-red",
                        {M::GreenWithoutEdgePreStep, M::BlueWithoutEdgePreStep});
}

void addOfSpanColours(Programs &programs)
{
    programs.addOfSpans("green-rate-of-red", {M::GreenRateOfRed});
    programs.addOfSpans("blue-rate-of-red", {M::BlueRateOfRed});
    programs.addOfSpans("blue-rate-of-green", {M::BlueRateOfGreen});
    programs.addOfSpans("rates-of-red", {M::GreenRateOfRed, M::BlueRateOfRed});
    programs.addOfSpans("no-colour-pre-step-of-green", {M::GreenWithoutPreStep});
    programs.addOfSpans("no-colour-pre-step-of-blue", {M::BlueWithoutPreStep});
    programs.addOfSpans("no-colour-pre-step-but-of-red",
                        {M::GreenWithoutPreStep, M::BlueWithoutPreStep});
    programs.addOfSpans("rounded-colour-rates", {M::RoundedRates});
    programs.addOfSpans("rounded-span-levels", {M::RoundedSpanLevels});
    programs.addOfSpans("span-levels-cut-behind-steps", {M::SpanLevelsCutBehindSteps});
    programs.addOfSpans("span-levels-rounded-behind-steps", {M::SpanLevelsRoundedBehindSteps});
    programs.addOfSpans("colour-divisor-minus-one", {M::SpanDivisorMinusOne});
    programs.addOfSpans("colours-of-lower-bound-alone", {M::LowerColourAlone});
    programs.addOfSpans("colours-of-upper-bound-alone", {M::UpperColourAlone});
    programs.addOfSpans("colours-mean-of-bounds", {M::MeanOfBounds});
    programs.addOfEnds("first-span-floor", "last-span-ceil", {M::FirstSpanFloor});
    programs.addOfEnds("first-span-nearest", "last-span-nearest", {M::FirstSpanNearest});
    programs.addOfEnds("extra-first-span", "extra-last-span", {M::FirstSpanTooMany});
    programs.addOfEnds("last-span-ceil", "first-span-floor", {M::LastSpanCeil});
    programs.addOfEnds("last-span-nearest", "first-span-nearest", {M::LastSpanNearest});
    programs.addOfEnds("extra-last-span", "extra-first-span", {M::LastSpanTooMany});
}

} // namespace

std::vector<MistakenProgram> mistakenPrograms()
{
    Programs programs;
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
