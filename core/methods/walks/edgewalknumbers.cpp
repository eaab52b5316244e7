// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/edgewalknumbers.h"

#include "core/methods/edgewalknames.h"
#include "core/methods/walks/edgewalkcolours.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

void appendPlace(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names)
{
    const bool isRow = names.isRow();
    table.push_back(
        {plainNumber("primitive", "tri", {}, "The triangle's place in drawing order, from 0."),
         [](const EdgeWalkSpanState &state) {
             return Quantity::integer(Int128(state.primitive));
         }});
    table.push_back({names.filled(plainNumber("{c}", "{c}", "px", "The {span}.")),
                     [isRow](const EdgeWalkSpanState &state) {
                         return Quantity::integer(isRow ? -state.column.x : state.column.x);
                     }});
    table.push_back({names.filled(plainNumber("{half}", "{half}", {},
                                              "1: between L₀₁ and L₀₂; 2: between L₁₂ and L₀₂.")),
                     [](const EdgeWalkSpanState &state) { return state.halfNumber(); },
                     [](NumberDescription &description, const EdgeWalkSpanState &state) {
                         description.toolTip = state.start.hasPlane
                             ? u"Between %1 and %2."_s.arg(nameOf(state.lower), nameOf(state.upper))
                             : u"Along L₀₂: the triangle has no area."_s;
                     }});
}

/// One bound's position: y_B or y_T, x_L or x_R.
void appendBound(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names, SpanBound bound)
{
    const bool isLower = bound == SpanBound::Lower;
    const bool isDirect = names.form().walk == WalkForm::Direct;
    const QString title = names.filled(isLower ? u"{a}_{lo}"_s : u"{a}_{hi}"_s);
    const QString word = isLower ? u"{lower}"_s : u"{upper}"_s;
    const QString fromVertex = names.filled(
        title + u" ← {a}_v + "_s + (names.isRow() ? u"(y_v − y)·m"_s : u"(x − x_v)·m"_s));
    table.push_back(
        {names.filled({.id = title,
                       .title = title,
                       .unit = "px",
                       .toolTip = u"Where the %1 edge meets the {span}."_s.arg(word),
                       .formula = isDirect ? fromVertex : u"%1 ← %1′ + m"_s.arg(title),
                       .startFormula = isDirect ? QString() : fromVertex,
                       .group = Group::Span,
                       .comparison = Comparison::WithExact,
                       .subject = isLower ? NumberSubject::LowerEdge : NumberSubject::UpperEdge}),
         [isLower](const EdgeWalkSpanState &state) {
             return isLower ? state.column.yBottom : state.column.yTop;
         },
         [=](NumberDescription &description, const EdgeWalkSpanState &state) {
             description.toolTip
                 = names.filled("Where %1, the %2 edge here, meets the {span}.")
                       .arg(nameOf(isLower ? state.lower : state.upper), names.filled(word));
             description.formula
                 = names.boundFormula(state, bound, title, names.filled("{a}"), "m");
             description.startFormula.clear();
         }});
}

/// The first or the last covered sample: ⌈y_B⌉ … ⌊y_T⌋, or as the fill rule and β change them.
void appendCoveredSample(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names,
                         SpanBound bound)
{
    const bool isLower = bound == SpanBound::Lower;
    const QString word = isLower ? u"first"_s : u"last"_s;
    const auto specify = [=](NumberDescription &description, Interval covered) {
        description.title = names.coveredSample(bound, covered);
        description.formula = names.filled(word + u" {across} = "_s) + description.title;
    };
    NumberDescription description
        = names.filled({.id = word + u"_{across}"_s,
                        .title = {},
                        .unit = "px",
                        .toolTip = u"The %1 covered {across}."_s.arg(word),
                        .group = Group::Span,
                        .comparison = Comparison::WithExact,
                        .subject = isLower ? NumberSubject::LowerEdge : NumberSubject::UpperEdge});
    specify(description, Interval::Closed);
    table.push_back({description,
                     [isLower](const EdgeWalkSpanState &state) {
                         return Quantity::integer(isLower ? state.column.firstRow
                                                          : state.column.endRow - 1);
                     },
                     [specify](NumberDescription &inForce, const EdgeWalkSpanState &state) {
                         specify(inForce, state.start.covered);
                     }});
}

void appendPixelCount(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names)
{
    table.push_back(
        {names.filled(plainNumber("pixels", "px", {},
                                  "Pixels written in this {span}, inside the frame.", {},
                                  Group::Span)),
         [](const EdgeWalkSpanState &state) { return Quantity::integer(state.drawnSamples()); }});
}

/// The first sample in the frame, from which the colours start.
void appendStart(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names)
{
    table.push_back({names.filled(plainNumber("first_drawn_{across}", "{a}_start", "px",
                                              "The first drawn {across}, where the colours start: "
                                              "the first covered one, or the frame's.",
                                              "{a}_start = max(first {across}, {a}_frame)",
                                              Group::EdgeColours)),
                     [](const EdgeWalkSpanState &state) {
                         return state.drawnSamples() > 0
                             ? Quantity::integer(state.column.firstDrawn)
                             : Quantity();
                     },
                     [names](NumberDescription &description, const EdgeWalkSpanState &state) {
                         // Otherwise it is the first covered one, whose formula is shown already.
                         description.formula = state.start.isClipped
                             ? names.filled("{a}_start = {a}_frame")
                             : QString();
                     }});
}

/// β of a bound in float64: half of 1/(ΔX·S), with lattice units converted to pixels.
QString boundBias(const EdgeWalkNames &names, const EdgeWalkSpanState &state, SpanBound bound)
{
    if ((bound == SpanBound::Lower ? state.biasBottom : state.biasTop).toDouble() == 0)
        return u"0"_s;
    const SortedEdge edge = bound == SpanBound::Lower ? state.lower : state.upper;
    if (names.hasNoSlope(state.corners, edge))
        return u"1/(2·256)"_s;
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    return u"1/(2·%1·256²)"_s.arg(names.way(ends[0], ends[1]));
}

void appendBiases(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names)
{
    for (const bool isLower : {true, false})
        table.push_back(
            {names.filled(
                 plainNumber(isLower ? u"bias_{lo}"_s : u"bias_{hi}"_s,
                             isLower ? u"β_{lo}"_s : u"β_{hi}"_s, "px",
                             u"Half the distance between the values that "_s
                                 + (isLower ? u"{a}_{lo}"_s : u"{a}_{hi}"_s)
                                 + u" can have; 0 where the edge is computed in integers."_s,
                             {}, Group::Span)),
             [isLower](const EdgeWalkSpanState &state) {
                 return isLower ? state.biasBottom : state.biasTop;
             },
             [=](NumberDescription &number, const EdgeWalkSpanState &state) {
                 number.formula = number.title + u" = "_s
                     + boundBias(names, state, isLower ? SpanBound::Lower : SpanBound::Upper);
             }});
}

} // namespace

NumberTable<EdgeWalkSpanState> edgeWalkSpanNumbers(const EdgeWalkForm &form)
{
    const EdgeWalkNames names(form);
    NumberTable<EdgeWalkSpanState> table;
    appendPlace(table, names);
    appendBound(table, names, SpanBound::Lower);
    appendBound(table, names, SpanBound::Upper);
    appendCoveredSample(table, names, SpanBound::Lower);
    appendCoveredSample(table, names, SpanBound::Upper);
    appendPixelCount(table, names);
    appendStart(table, names);
    if (form.walk == WalkForm::Direct)
        appendBiases(table, names);
    appendEdgeWalkColours(table, names);
    return table;
}

} // namespace pixelplumb
