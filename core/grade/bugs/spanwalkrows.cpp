// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/walkrows.h"

namespace pixelplumb {

namespace {

constexpr const char *boundEndsQuestion
    = "From which to which sample does a span go? What if its bound lies "
      "between two?";
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
         {.first = down, .last = down, .overflow = LevelOverflow::Wraps}},
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
        {"first-sample-zero",
         boundEndsQuestion,
         "Each %1 begins at %3 = 0, not at its lower bound; its colours are drawn out beyond the "
         "bound.",
         {.first = EndRounding::AtZero}},
        {"first-sample-zero-of-bound-colour",
         boundEndsQuestion,
         "Each %1 begins at %3 = 0, not at its lower bound, with the colour of the bound.",
         {.spanPreStep = PreStep::None, .first = EndRounding::AtZero}},
    };
}

/// Where a triangle begins and ends: a %1 that its vertex does not reach lies between its edges,
/// extended beyond the vertex.
std::vector<WalkRow> spanEndRows()
{
    return {
        {"first-span-floor",
         walkquestions::triangleEnds,
         "The %1s of a triangle begin at ⌊%2⌋ of the vertex with the least %2, not at ⌈%2⌉: where "
         "it lies between two, there is one that its edges do not reach.",
         {.leastSpan = SpanEnd::Outward}},
        {"first-span-nearest",
         walkquestions::triangleEnds,
         "The %1s of a triangle begin at the one that is nearest to the vertex with the least %2, "
         "not at ⌈%2⌉.",
         {.leastSpan = SpanEnd::Nearest}},
        {"last-span-ceil",
         walkquestions::triangleEnds,
         "The %1s of a triangle end at ⌈%2⌉ of the vertex with the greatest %2, not at ⌊%2⌋: where "
         "it lies between two, there is one that its edges do not reach.",
         {.greatestSpan = SpanEnd::Outward}},
        {"last-span-nearest",
         walkquestions::triangleEnds,
         "The %1s of a triangle end at the one that is nearest to the vertex with the greatest %2, "
         "not at ⌊%2⌋.",
         {.greatestSpan = SpanEnd::Nearest}},
        {"first-span-zero",
         walkquestions::triangleEnds,
         "The %1s of a triangle begin at %2 = 0, not at ⌈%2⌉ of the vertex with the least %2: its "
         "edges are drawn out beyond that vertex.",
         {.leastSpan = SpanEnd::AtZero}},
    };
}

std::vector<WalkRow> boundRows()
{
    return {
        {"colours-of-bounds-exchanged",
         walkquestions::bounds,
         "The colours of the two bounds are exchanged: a %1 goes from the upper bound's colour at "
         "its lower bound to the lower bound's at its upper one.",
         {.lowerColours = LowerColours::OfUpperEdge}},
        {"colours-from-upper-bound",
         walkquestions::bounds,
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
        for (const std::vector<WalkRow> &some : {endRows(), spanEndRows(), boundRows()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return rows;
}

} // namespace pixelplumb
