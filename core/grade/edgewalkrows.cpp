// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *firstSpanQuestion
    = "How far is it from a vertex to the first %1 behind it, and in which direction?";
constexpr const char *middleQuestion
    = "Which edge ends at the middle vertex, which begins there, and which goes on?";
constexpr const char *sortQuestion = "Which vertex is P₀? For every triangle?";
constexpr const char *placesQuestion = "What type has an edge's %3 while it is stepped?";

std::vector<WalkRow> numberRows()
{
    constexpr auto whole = Kept::TowardZero;
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
        {"whole-places",
         placesQuestion,
         "An edge's %3 is kept as a whole number: at each %1 its fraction is lost, not so that of "
         "its colours.",
         {.edgePlaces = whole}},
        {"rounded-places",
         placesQuestion,
         "An edge's %3 is kept as a whole number: at each %1 it is rounded to the nearest, its "
         "colours are not.",
         {.edgePlaces = Kept::Nearest}},
    };
}

std::vector<WalkRow> stepRows()
{
    return {
        {"colours-without-edge-pre-step",
         "Which colour has an edge where it meets its first %1? Not its vertex' own.",
         "The colours of an edge begin with its vertex' own at its first %1; its ends have their "
         "pre-step.",
         {.edgeColourPreStep = PreStep::None}},
        {"edge-pre-step-of-fraction",
         firstSpanQuestion,
         "The pre-step of an edge, of its place and of its colours, goes by %6 in place of %5.",
         {.placePreStep = PreStep::Fraction, .edgeColourPreStep = PreStep::Fraction}},
        {"edge-pre-step-backward",
         firstSpanQuestion,
         "The pre-step of an edge by %5, of its place and of its colours, is subtracted, not "
         "added.",
         {.placePreStep = PreStep::Backward, .edgeColourPreStep = PreStep::Backward}},
        {"loops-truncated",
         "At which %1 do your loops begin and end, and where is the edge there?",
         "Loops go from (int)%2 of a vertex to (int)%2 of the next; an edge has its vertex' own "
         "place and colour at the first %1.",
         {.spans = EndRounding::Down}},
        {"edges-stepped-first",
         "Which comes first, that a %1 is drawn or that its edges are stepped?",
         "The edges are stepped before a %1 is drawn, not behind it: each %1 has the ends and the "
         "colours that belong to the next one.",
         {.edgeStepping = Stepping::BeforeDrawing}},
        {"edges-wait-at-empty-spans",
         "What is done at a %1 between whose bounds no sample lies?",
         "At a %1 without samples the edges are not stepped (continue): at all that follow they "
         "are late.",
         {.emptySpans = EmptySpan::Waits}},
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
        {"vertices-not-sorted",
         sortQuestion,
         "The vertices are not sorted: the loops go from %2 of the first one given to that of the "
         "second and on to that of the third, and do nothing where that lies before; the long "
         "edge begins at the first and is stepped as often as a loop goes round.",
         {.vertices = VertexOrder::AsGiven}},
        {"vertices-sorted-by-the-other",
         sortQuestion,
         "The vertices are sorted by %3, the least first, not by %2: the loops go from %2 of the "
         "first one to that of the second and on to that of the third, and do nothing where that "
         "lies before; the long edge begins at the first and is stepped as often as a loop goes "
         "round.",
         {.vertices = VertexOrder::ByY}},
    };
}

std::vector<WalkRow> middleRows()
{
    constexpr auto carriedOn = ShortEdgeBehind::CarriedOn;
    constexpr auto fromMiddle = LongEdgeBehind::FromMiddle;
    constexpr auto stands = LongEdgeBehind::Stands;
    return {
        {"no-pre-step-behind-middle",
         "Where does the second of the two short edges begin? And which colour has it there?",
         "The edge from the middle vertex to the last has no pre-step: at its first %1 it has the "
         "vertex' own place and colour. The others have theirs.",
         {.departuresBehindMiddle = VariantSet().with(Variant::NoEdgePreStep)}},
        {"second-edge-of-first-colour",
         middleQuestion,
         "The edge from the middle vertex to the last begins there with the colours of the first "
         "vertex, and is stepped by its own; its %3 is right.",
         {.shortColoursBehind = ShortEdgeBehind::FromFirst}},
        {"second-edge-carried-on",
         middleQuestion,
         "The edge from the middle vertex to the last is not begun there: %3 and colours go on "
         "from what the edge before it has come to, by steps of its own.",
         {.shortPlacesBehind = carriedOn, .shortColoursBehind = carriedOn}},
        {"second-edge-place-carried-on",
         middleQuestion,
         "The edge from the middle vertex to the last is not begun there: its %3 goes on from what "
         "the edge before it has come to, by steps of its own; its colours are right.",
         {.shortPlacesBehind = carriedOn}},
        {"second-edge-colours-carried-on",
         middleQuestion,
         "The colours of the edge from the middle vertex to the last are not begun there: they go "
         "on from what those of the edge before it have come to, by steps of its own; its %3 is "
         "right.",
         {.shortColoursBehind = carriedOn}},
        {"long-edge-begun-again",
         middleQuestion,
         "The long edge begins again with the middle vertex' place and colours, and goes on by its "
         "own steps.",
         {.longPlacesBehind = fromMiddle, .longColoursBehind = fromMiddle}},
        {"long-edge-place-begun-again",
         middleQuestion,
         "The long edge begins again with the middle vertex' place, and goes on by its own steps; "
         "its colours are right.",
         {.longPlacesBehind = fromMiddle}},
        {"long-edge-colours-begun-again",
         middleQuestion,
         "The colours of the long edge begin again with the middle vertex', and go on by its own "
         "steps; its %3 is right.",
         {.longColoursBehind = fromMiddle}},
        {"long-edge-stands",
         middleQuestion,
         "The long edge is not stepped behind the middle vertex, neither its %3 nor its colours.",
         {.longPlacesBehind = stands, .longColoursBehind = stands}},
        {"long-edge-place-stands",
         middleQuestion,
         "The long edge's %3 is not stepped behind the middle vertex; its colours are.",
         {.longPlacesBehind = stands}},
        {"long-edge-colours-stand",
         middleQuestion,
         "The long edge's colours are not stepped behind the middle vertex; its %3 is.",
         {.longColoursBehind = stands}},
    };
}

} // namespace

const std::vector<WalkRow> &edgeWalkRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all;
        for (const std::vector<WalkRow> &some : {stepRows(), numberRows(), middleRows()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
