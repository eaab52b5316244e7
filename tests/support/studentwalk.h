// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

#include <set>

namespace pixelplumb {

/// The mistakes of a student's program.
enum class WalkMistake {
    FromBelow, ///< no mistake: rows from the least y upwards
    NoEdgePreStep,
    NoEdgeColourPreStep,
    EdgeDivisorMinusOne,
    EdgeDivisorPlusOne,
    UnsortedColours,
    WholeSlopes,
    WholeEdgeColours,
    WholePreSteps,
    WholeSteps,
    SpanDivisorPlusOne,
    ColoursBetweenSamples,
    LastSpanMissing, ///< x < ⌊x₂⌋
    OpenAtLastVertex, ///< x < x₂
    FirstSpanMissing, ///< from ⌈x₀⌉ + 1
    OpenAtFirstVertex, ///< x > x₀
    FirstHalfTruncated, ///< x < ⌊x₁⌋
    SecondHalfAfterCeiling, ///< from ⌈x₁⌉ + 1
    SecondHalfAfterFloor, ///< from ⌊x₁⌋ + 1
    FirstHalfWithMiddle, ///< x <= x₁
    NoFirstHalf,
    NoSecondHalf,
    LoopsTruncated, ///< from (int)x₀ with y₀ to (int)x₁, on with y₁ to (int)x₂
    DividesDown, ///< no mistake by itself: // of Python where others divide as C does
    WholeSpanLevels, ///< int r = …; r += ΔR;
    WholeEdgeLevels,
    LongEdgeAlwaysUpper,
    LongEdgeAlwaysLower,
    ShortEdgesColoursBelow, ///< if (y_B > y_T) swap(y_B, y_T), y_B being the short edge's
    LongEdgesColoursBelow, ///< the same swap, y_B being the long edge's
    SpanDivisorSamples, ///< ΔR = (R_T − R_B)/(⌊y_T⌋ − ⌈y_B⌉ + 1)
    SpanDivisorSteps, ///< ΔR = (R_T − R_B)/(⌊y_T⌋ − ⌈y_B⌉)
    SpanPreStepOfFraction,
    SpanPreStepBackward,
    ColoursSteppedFirst,
    LastSampleTooMany,
    FirstSampleTooMany,
    FirstSampleTooManyOfNextColour,
    RedNotSteppedAlongSpans,
    GreenNotSteppedAlongSpans,
    BlueNotSteppedAlongSpans,
    OutlineAlone,
    RedNotSteppedAlongEdges,
    GreenNotSteppedAlongEdges,
    BlueNotSteppedAlongEdges,
    EdgePreStepOfFraction,
    EdgePreStepBackward,
    PlacesSteppedFirst,
    EdgeColoursSteppedFirst,
    EmptySpansContinue, ///< if (⌈y_B⌉ > ⌊y_T⌋) continue, before the increments
    WholePlaces, ///< int y; y += m
    RoundedPlaces, ///< y = round(y + m)
    NotSorted,
    SortedByTheOther,
    EqualAsGiven, ///< no mistake by itself: vertices of equal x in the given order
    EqualDescending, ///< no mistake by itself
    FlatEndFromVertices, ///< no mistake by itself: if (x₁ == x₂) from (y₁, R₁) to (y₂, R₂)
    FlatEndFromEdges, ///< no mistake by itself: if (x₁ == x₂) L₀₁ continues for one more
    SecondEdgeOfFirstColour,
    SecondPlaceCarriedOn,
    SecondColoursCarriedOn,
    LongPlaceBegunAgain,
    LongColoursBegunAgain,
    LongPlaceStands,
    LongColoursStand,
    ReturnsAtFirstVertical, ///< if (x₀ == x₁) return
    ReturnsAtLastVertical, ///< if (x₁ == x₂) return
    NoSecondHalfAtVertical, ///< if (x₁ == x₂) return, after the first half
    LowerBoundLeftOut, ///< from (int)y_B + 1
    UpperBoundLeftOut, ///< y < y_T
    FirstSampleNearest,
    LastSampleNearest,
    BoundColoursExchanged,
    WholeBoundColours, ///< int rB = …
    RoundedBoundColours,
    ColoursFromUpperBound, ///< r = R_T, and up from there
    ColourStepNegated, ///< ΔR = (R_B − R_T)/…
    FilledFromLastSample,
    SpanPreStepWithoutRate, ///< R_B + (⌈y_B⌉ − y_B)
    GreenSteppedAsRed,
    BlueSteppedAsRed,
    BlueSteppedAsGreen,
    SidesByFirstVertex, ///< if (y₁ < y₀) L₀₂ is above
    SidesByLastVertex,
    PlaceWithoutPreStep,
    SlopesInverted,
    SlopesNegated,
    RoundedSlopes,
    SlopeDivisorMinusOne,
    SlopeDivisorPlusOne,
    ColourDivisorMinusOne,
    ColourDivisorPlusOne,
    SortedByComparisons, ///< by some of the comparisons below, in this order
    Compares12First,
    Compares01,
    Compares02,
    Compares12Last,
    SecondEdgeOfFirstPlace,
    SecondSlopeOfFirst, ///< m of L₀₁ goes on
    SecondStepsOfFirst, ///< ΔR of L₀₁ goes on
    SecondColoursToo,
    // L₀₁ and L₁₂ with values of L₀₂, L₀₂ with values of L₀₁.
    OtherRiseOfFirst, ///< (y₂ − y₀)/(x₁ − x₀)
    OtherRiseOfSecond, ///< (y₂ − y₀)/(x₂ − x₁)
    OtherRiseOfLong, ///< (y₁ − y₀)/(x₂ − x₀)
    OtherRunOfFirst, ///< (y₁ − y₀)/(x₂ − x₀)
    OtherRunOfSecond, ///< (y₂ − y₁)/(x₂ − x₀)
    OtherRunOfLong, ///< (y₂ − y₀)/(x₁ − x₀)
    OtherColoursOfFirst, ///< likewise for R G B
    OtherColoursOfSecond,
    OtherColoursOfLong,
    OtherColourRunOfFirst,
    OtherColourRunOfSecond,
    OtherColourRunOfLong,
    LongPlaceBegunAgainAtFirst,
    LongColoursBegunAgainAtFirst,
    LongPlaceWaits,
    LongColoursWait,
    NoPreStepOfFirst,
    NoPreStepOfSecond,
    NoPreStepOfLong,
    WholeSlopeOfFirst,
    WholeSlopeOfSecond,
    WholeSlopeOfLong,
    SlopeOfFirstNegated,
    SlopeOfSecondNegated,
    SlopeOfLongNegated,
    GreenRateOfRed, ///< ΔG = (R_T − R_B)/…
    BlueRateOfRed,
    BlueRateOfGreen,
    RedWithoutPreStep,
    GreenWithoutPreStep,
    BlueWithoutPreStep,
    RoundedRates, ///< ΔR = round((R_T − R_B)/…)
    RoundedSpanLevels,
    SpanLevelsCutBehindSteps, ///< r = int(r + ΔR)
    SpanLevelsRoundedBehindSteps,
    SpanDivisorMinusOne,
    LowerColourAlone,
    UpperColourAlone,
    MeanOfBounds,
    ColoursGoOn, ///< r = … before the loop over columns, not in it
    ColoursGoOnInHalf,
    FirstSpanFloor,
    FirstSpanNearest,
    FirstSpanTooMany,
    LastSpanCeil,
    LastSpanNearest,
    LastSpanTooMany,
    SecondHalfTooEarly, ///< from ⌊x₁⌋
    SecondHalfFromNearest,
    EdgeColoursByRise, ///< (R₁ − R₀)/(y₁ − y₀)
    EdgeColoursByLengthOfRise,
    EdgeColoursNegated,
    RoundedEdgeColours,
    RoundedEdgeLevels,
    EdgeLevelsCutBehindSteps,
    EdgeLevelsRoundedBehindSteps,
    PlacesCutBehindSteps, ///< y = int(y + m)
    PlacesRoundedBehindSteps,
    RunsOfWholeEnds, ///< (int)x₁ − (int)x₀
    GreenRateOfRedAlongEdges,
    BlueRateOfRedAlongEdges,
    BlueRateOfGreenAlongEdges,
    GreenSteppedAsRedAlongEdges,
    BlueSteppedAsRedAlongEdges,
    BlueSteppedAsGreenAlongEdges,
    RedWithoutEdgePreStep,
    GreenWithoutEdgePreStep,
    BlueWithoutEdgePreStep,
    SidesBySlopes, ///< if (m₀₁ <= m₀₂) L₀₁ is below, m of a vertical edge being 0
    ShortSlopesExchanged, ///< swap(m₀₁, m₁₂)
    FirstAndLongSlopesExchanged,
    SecondAndLongSlopesExchanged,
    SlopesOfMagnitudes, ///< abs(y₁ − y₀)/(x₁ − x₀)
    LongWithoutPreStepBehindMiddle, ///< y₀ + (x₁ − x₀)·m₀₂ at ⌈x₁⌉
    SpanDivisorOfFloors, ///< ΔR = (R_T − R_B)/(⌊y_T⌋ − ⌊y_B⌋), 0 where this is 0
    ShortSpansNotStepped, ///< ΔR = y_T − y_B >= 1 ? … : 0
    FirstSpanLevelCut, ///< r = int(R_B + (⌈y_B⌉ − y_B)·ΔR), then uncut steps of ΔR
};

enum class WalkLines { Columns, Rows };

/// What a student's program draws of a scene of triangles, in fractions: the two loops of the
/// assignment, written from its text alone and without any code of the core's kernels. Rows start
/// at the greatest y, except with FromBelow.
Picture studentPicture(const Scene &scene, WalkLines lines, const std::set<WalkMistake> &mistakes);
/// Like studentPicture(), but in numbers that round.
Picture studentPictureInDouble(const Scene &scene, WalkLines lines,
                               const std::set<WalkMistake> &mistakes);

} // namespace pixelplumb
