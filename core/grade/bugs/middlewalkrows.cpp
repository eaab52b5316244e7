// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *singleEdgeQuestion
    = "Are all three edges computed alike? Compare the lines one by one.";

std::vector<WalkRow> shortEdgeRows()
{
    constexpr auto carriedOn = ShortEdgeBehind::CarriedOn;
    return {
        {"no-pre-step-behind-middle",
         "Where does the second of the two short edges begin? And what colour does it have there?",
         "The edge from the middle vertex to the last has no pre-step: at its first %1 it has the "
         "vertex' own place and colour. The others have theirs.",
         {.edgeChanges = edgechange::noPreStep, .departing = WalkedEdges::Second}},
        {"no-pre-step-of-first-edge",
         "Where does the first of the two short edges meet its first %1?",
         "The edge from the first vertex to the middle one has no pre-step: at its first %1 it has "
         "the vertex' own place and colour. The others have theirs.",
         {.edgeChanges = edgechange::noPreStep, .departing = WalkedEdges::First}},
        {"no-pre-step-of-long-edge",
         "Where does the long edge meet its first %1?",
         "The long edge has no pre-step: at its first %1 it has the vertex' own place and colour. "
         "The others have theirs.",
         {.edgeChanges = edgechange::noPreStep, .departing = WalkedEdges::Long}},
        {"middle-span-in-both-halves",
         "To which of the two halves does the %1 of the middle vertex belong?",
         "The %1 on which the middle vertex lies is drawn in both halves, ≤ in the first one's "
         "loop: for the second one the long edge has been stepped once too often.",
         {.middleSpan = MiddleSpan::InBothHalves}},
        {"second-half-too-early",
         walkquestions::middle,
         "Where the middle vertex lies between two, the second half begins at the %1 before it: "
         "there the edge to the last vertex is drawn out beyond it.",
         {.middleSpan = MiddleSpan::FromSpanBefore}},
        {"second-half-from-nearest",
         walkquestions::middle,
         "The second half begins at the %1 that is nearest to the middle vertex, which may lie "
         "before it: there the edge to the last vertex is drawn out beyond it.",
         {.middleSpan = MiddleSpan::FromNearest}},
        {"second-edge-of-first-place",
         walkquestions::middle,
         "The edge from the middle vertex to the last begins there with the %3 of the first "
         "vertex, and is stepped by its own slope; its colours are right.",
         {.shortPlacesBehind = ShortEdgeBehind::FromFirst}},
        {"second-edge-of-first-colour",
         walkquestions::middle,
         "The edge from the middle vertex to the last begins there with the colours of the first "
         "vertex, and is stepped by its own; its %3 is right.",
         {.shortColoursBehind = ShortEdgeBehind::FromFirst}},
        {"second-edge-carried-on",
         walkquestions::middle,
         "The edge from the middle vertex to the last is not begun there: %3 and colours go on "
         "from what the edge before it has come to, by steps of its own.",
         {.shortPlacesBehind = carriedOn, .shortColoursBehind = carriedOn}},
        {"second-edge-place-carried-on",
         walkquestions::middle,
         "The edge from the middle vertex to the last is not begun there: its %3 goes on from what "
         "the edge before it has come to, by steps of its own; its colours are right.",
         {.shortPlacesBehind = carriedOn}},
        {"second-edge-colours-carried-on",
         walkquestions::middle,
         "The colours of the edge from the middle vertex to the last are not begun there: they go "
         "on from what those of the edge before it have come to, by steps of its own; its %3 is "
         "right.",
         {.shortColoursBehind = carriedOn}},
    };
}

std::vector<WalkRow> longEdgeRows()
{
    constexpr auto fromMiddle = LongEdgeBehind::FromMiddle;
    constexpr auto fromFirst = LongEdgeBehind::FromFirst;
    constexpr auto stands = LongEdgeBehind::Stands;
    constexpr auto waits = LongEdgeBefore::Waits;
    return {
        {"long-edge-begun-again",
         walkquestions::middle,
         "The long edge begins again with the middle vertex' place and colours, and goes on by its "
         "own steps.",
         {.longPlacesBehind = fromMiddle, .longColoursBehind = fromMiddle}},
        {"long-edge-place-begun-again",
         walkquestions::middle,
         "The long edge begins again with the middle vertex' place, and goes on by its own steps; "
         "its colours are right.",
         {.longPlacesBehind = fromMiddle}},
        {"long-edge-colours-begun-again",
         walkquestions::middle,
         "The colours of the long edge begin again with the middle vertex', and go on by its own "
         "steps; its %3 is right.",
         {.longColoursBehind = fromMiddle}},
        {"long-edge-stands",
         walkquestions::middle,
         "The long edge is not stepped behind the middle vertex, neither its %3 nor its colours.",
         {.longPlacesBehind = stands, .longColoursBehind = stands}},
        {"long-edge-place-stands",
         walkquestions::middle,
         "The long edge's %3 is not stepped behind the middle vertex; its colours are.",
         {.longPlacesBehind = stands}},
        {"long-edge-colours-stand",
         walkquestions::middle,
         "The long edge's colours are not stepped behind the middle vertex; its %3 is.",
         {.longColoursBehind = stands}},
        {"long-edge-begun-again-at-first",
         walkquestions::middle,
         "In the second half the long edge begins again, with the first vertex' place and colours.",
         {.longPlacesBehind = fromFirst, .longColoursBehind = fromFirst}},
        {"long-edge-place-begun-again-at-first",
         walkquestions::middle,
         "In the second half the long edge begins again with the first vertex' place; its colours "
         "go on.",
         {.longPlacesBehind = fromFirst}},
        {"long-edge-colours-begun-again-at-first",
         walkquestions::middle,
         "In the second half the long edge begins again with the first vertex' colours; its %3 "
         "goes on.",
         {.longColoursBehind = fromFirst}},
        {"long-edge-without-pre-step-behind-middle",
         walkquestions::middle,
         "In the second half the long edge begins again with its own place and colours beside the "
         "middle vertex, without the pre-step from there to the half's first %1.",
         {.longPlacesBehind = LongEdgeBehind::WithoutPreStep,
          .longColoursBehind = LongEdgeBehind::WithoutPreStep}},
        {"long-edge-waits",
         walkquestions::middle,
         "The long edge is not stepped before the middle vertex, neither its %3 nor its colours: "
         "it begins there with what belongs to the first %1.",
         {.longPlacesBefore = waits, .longColoursBefore = waits}},
        {"long-edge-place-waits",
         walkquestions::middle,
         "The long edge's %3 is not stepped before the middle vertex; its colours are.",
         {.longPlacesBefore = waits}},
        {"long-edge-colours-wait",
         walkquestions::middle,
         "The long edge's colours are not stepped before the middle vertex; its %3 is.",
         {.longColoursBefore = waits}},
    };
}

/// Mistakes on only one of the three edges.
std::vector<WalkRow> singleEdgeRows()
{
    constexpr auto whole = Truncation::TowardZero;
    constexpr auto negated = SlopeForm::Negated;
    return {
        {"whole-slope-of-first-edge",
         singleEdgeQuestion,
         "The slope of the edge from the first vertex to the middle one is a whole number; those "
         "of "
         "the others are not.",
         {.departing = WalkedEdges::First, .slopes = whole}},
        {"whole-slope-of-second-edge",
         singleEdgeQuestion,
         "The slope of the edge from the middle vertex to the last is a whole number; those of the "
         "others are not.",
         {.departing = WalkedEdges::Second, .slopes = whole}},
        {"whole-slope-of-long-edge",
         singleEdgeQuestion,
         "The slope of the long edge is a whole number; those of the others are not.",
         {.departing = WalkedEdges::Long, .slopes = whole}},
        {"slope-of-first-edge-negated",
         singleEdgeQuestion,
         "The slope of the edge from the first vertex to the middle one has the wrong sign.",
         {.departing = WalkedEdges::First, .slopeForm = negated}},
        {"slope-of-second-edge-negated",
         singleEdgeQuestion,
         "The slope of the edge from the middle vertex to the last has the wrong sign.",
         {.departing = WalkedEdges::Second, .slopeForm = negated}},
        {"slope-of-long-edge-negated",
         singleEdgeQuestion,
         "The slope of the long edge has the wrong sign.",
         {.departing = WalkedEdges::Long, .slopeForm = negated}},
    };
}

} // namespace

const std::vector<WalkRow> &middleWalkRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all;
        for (const std::vector<WalkRow> &some : {shortEdgeRows(), longEdgeRows(), singleEdgeRows()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
