// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *firstSpanQuestion
    = "How far is it from a vertex to the first %1 after it, and in which direction?";
constexpr const char *steppedFirstQuestion
    = "Which comes first, drawing a %1 or stepping its edges?";
constexpr const char *slopeQuestion = "What is a slope, and which of its parts has which sign?";
constexpr const char *sortQuestion = "Which vertex is P₀? For every triangle?";

std::vector<WalkRow> stepRows()
{
    return {
        {"colours-without-edge-pre-step",
         "What colour does an edge have where it meets its first %1? Not its vertex's own.",
         "The colours of an edge begin with its vertex' own at its first %1; its ends have their "
         "pre-step.",
         {.edgeColourPreStep = PreStep::None}},
        {"place-without-edge-pre-step",
         "Where does an edge meet its first %1? Not at its vertex.",
         "The %3 of an edge begins with its vertex' own at its first %1; its colours have their "
         "pre-step.",
         {.placePreStep = PreStep::None}},
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
         steppedFirstQuestion,
         "The edges are stepped before a %1 is drawn, not after it: each %1 has the ends and the "
         "colours that belong to the next one.",
         {.placeStepping = Stepping::BeforeDrawing, .edgeColourStepping = Stepping::BeforeDrawing}},
        {"places-stepped-first",
         steppedFirstQuestion,
         "The %3 of the edges is stepped before a %1 is drawn, their colours behind it: each %1 "
         "has "
         "the ends of the next one and its own colours.",
         {.placeStepping = Stepping::BeforeDrawing}},
        {"edge-colours-stepped-first",
         steppedFirstQuestion,
         "The colours of the edges are stepped before a %1 is drawn, their %3 behind it: each %1 "
         "has its own ends and the colours of the next one.",
         {.edgeColourStepping = Stepping::BeforeDrawing}},
        {"extra-first-span",
         walkquestions::triangleEnds,
         "The %1s of a triangle begin one too early, at ⌈%2⌉ − 1 of the vertex with the least %2, "
         "even where it lies on one.",
         {.leastSpan = SpanEnd::OneMore}},
        {"extra-last-span",
         walkquestions::triangleEnds,
         "The %1s of a triangle end one too late, at ⌊%2⌋ + 1 of the vertex with the greatest %2, "
         "even where it lies on one.",
         {.greatestSpan = SpanEnd::OneMore}},
        {"edges-wait-at-empty-spans",
         "What is done at a %1 between whose bounds no sample lies?",
         "At a %1 without samples the edges are not stepped (continue): at all that follow they "
         "are late.",
         {.emptySpans = EmptySpan::Waits}},
    };
}

std::vector<WalkRow> orderRows()
{
    return {
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
        {"sorted-by-01",
         sortQuestion,
         "Only the first vertex given is compared with the second and exchanged with it; the third "
         "stays the last.",
         {.vertices = VertexOrder::Compared01}},
        {"sorted-by-12",
         sortQuestion,
         "Only the second vertex given is compared with the third and exchanged with it; the first "
         "stays the first.",
         {.vertices = VertexOrder::Compared12}},
        {"sorted-by-02",
         sortQuestion,
         "Only the first vertex given is compared with the third and exchanged with it; the second "
         "stays the middle one.",
         {.vertices = VertexOrder::Compared02}},
        {"sorted-by-01-12",
         sortQuestion,
         "Of the three comparisons that sort three vertices the last is missing: the first with "
         "the second, then the second with the third. The greatest %2 is last, the two before it "
         "may be exchanged.",
         {.vertices = VertexOrder::Compared01And12}},
        {"sorted-by-12-01",
         sortQuestion,
         "Of the three comparisons that sort three vertices the last is missing: the second with "
         "the third, then the first with the second. The least %2 is first, the two behind it may "
         "be exchanged.",
         {.vertices = VertexOrder::Compared12And01}},
        {"sorted-by-01-02",
         sortQuestion,
         "Of the three comparisons that sort three vertices the last is missing: the first with "
         "the second, then the first with the third. The least %2 is first, the two behind it may "
         "be exchanged.",
         {.vertices = VertexOrder::Compared01And02}},
        {"sorted-by-02-12",
         sortQuestion,
         "Of the three comparisons that sort three vertices the last is missing: the first with "
         "the third, then the second with the third. The greatest %2 is last, the two before it "
         "may be exchanged.",
         {.vertices = VertexOrder::Compared02And12}},
    };
}

std::vector<WalkRow> rateRows()
{
    return {
        {"slopes-inverted",
         slopeQuestion,
         "The slope of an edge is Δ%2/Δ%3 in place of Δ%3/Δ%2; its colours are divided by Δ%2.",
         {.slopeForm = SlopeForm::RunOverRise}},
        {"slopes-negated",
         slopeQuestion,
         "The slopes of all edges have the wrong sign.",
         {.slopeForm = SlopeForm::Negated}},
        {"slopes-of-magnitudes",
         slopeQuestion,
         "The slope of an edge is |Δ%3|/Δ%2 in place of Δ%3/Δ%2: none has the other sign.",
         {.slopeForm = SlopeForm::OfMagnitude}},
        {"runs-of-whole-ends",
         walkquestions::edgeDivisor,
         "Δ%2 of an edge, by which its slope and its colours are divided, is the difference of two "
         "whole numbers, (int)%2 of its vertices; it begins where it should.",
         {.runEnds = Truncation::TowardZero}},
        {"slope-divisor-minus-one",
         walkquestions::edgeDivisor,
         "The slope of an edge is divided by Δ%2 − 1 in place of Δ%2; its colours are not.",
         {.edgeChanges = edgechange::divisorMinusOne, .divided = EdgeRates::Slope}},
        {"slope-divisor-plus-one",
         walkquestions::edgeDivisor,
         "The slope of an edge is divided by Δ%2 + 1 in place of Δ%2; its colours are not.",
         {.edgeChanges = edgechange::divisorPlusOne, .divided = EdgeRates::Slope}},
    };
}

/// Mistakes only of columns: in rows the lesser x is the left bound, whatever the slopes.
std::vector<WalkRow> columnRows()
{
    return {
        {"sides-by-slopes",
         "Which of the two edges is the upper bound? Which slope has one along a %1?",
         "Which of the two edges that begin at the first vertex is the lower bound is told by "
         "their slopes, m₀₁ ≤ m₀₂, and an edge along a %1 is given the slope 0: where two "
         "vertices lie on the first %1 bounds are exchanged, and the triangle is not drawn, where "
         "the long edge does not go back.",
         {.upperEdge = UpperEdge::LongBySlopes}},
    };
}

} // namespace

const std::vector<WalkRow> &edgeWalkRows()
{
    static const std::vector<WalkRow> rows = [] {
        std::vector<WalkRow> all;
        for (const std::vector<WalkRow> &some : {stepRows(), orderRows(), rateRows(), columnRows()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
