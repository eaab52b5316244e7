// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programlist.h"

namespace pixelplumb {

using M = WalkMistake;

void addOfOtherRates(ProgramList &programs)
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
    programs.addOfEdges("slopes-of-short-edges-exchanged", {M::ShortSlopesExchanged});
    programs.addOfEdges("slopes-of-first-and-long-edge-exchanged",
                        {M::FirstAndLongSlopesExchanged});
    programs.addOfEdges("slopes-of-second-and-long-edge-exchanged",
                        {M::SecondAndLongSlopesExchanged});
}

void addOfEdgeColours(ProgramList &programs)
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

void addOfSpanColours(ProgramList &programs)
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
    programs.addOfSpans("short-spans-not-stepped", {M::ShortSpansNotStepped});
    programs.addOfSpans("colour-divisor-of-floors", {M::SpanDivisorOfFloors});
    programs.addOfSpans("first-span-levels-cut", {M::FirstSpanLevelCut});
    programs.addOfSpans("colours-of-lower-bound-alone", {M::LowerColourAlone});
    programs.addOfSpans("colours-of-upper-bound-alone", {M::UpperColourAlone});
    programs.addOfSpans("colours-mean-of-bounds", {M::MeanOfBounds});
    programs.addOfEnds("first-span-floor", "last-span-ceil", {M::FirstSpanFloor});
    programs.addOfEnds("first-span-nearest", "last-span-nearest", {M::FirstSpanNearest});
    programs.addOfEnds("last-span-ceil", "first-span-floor", {M::LastSpanCeil});
    programs.addOfEnds("last-span-nearest", "first-span-nearest", {M::LastSpanNearest});
    programs.addOfEndsInOrder("extra-first-span", "extra-last-span", "extra-first-span-from-below",
                              {M::FirstSpanTooMany});
    programs.addOfEndsInOrder("extra-last-span", "extra-first-span", "extra-last-span-from-below",
                              {M::LastSpanTooMany});
}

} // namespace pixelplumb
