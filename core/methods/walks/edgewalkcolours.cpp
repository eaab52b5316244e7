// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/edgewalkcolours.h"

#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// The levels at one bound: R_B G_B B_B or R_T G_T B_T.
void appendBoundColours(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names,
                        SpanBound bound)
{
    const bool isLower = bound == SpanBound::Lower;
    const bool isDirect = names.form().walk == WalkForm::Direct;
    const QString title = u'%' + names.filled(isLower ? u"_{lo}"_s : u"_{hi}"_s);
    const QString word = isLower ? u"{lower}"_s : u"{upper}"_s;
    const QString fromVertex
        = title + (names.isRow() ? u" ← %_v + (y_v − y)·δ%"_s : u" ← %_v + (x − x_v)·δ%"_s);
    appendChannels(
        table,
        names.filled({.id = title,
                      .title = title,
                      .unit = "levels",
                      .toolTip = u"Level of % where the "_s + word + u" edge meets the {span}."_s,
                      .formula = isDirect ? fromVertex : title + u" ← "_s + title + u"′ + δ%"_s,
                      .startFormula = isDirect ? QString() : fromVertex,
                      .group = Group::EdgeColours,
                      .comparison = Comparison::WithExact}),
        [isLower](const EdgeWalkSpanState &state, std::size_t channel) {
            return isLower ? state.column.colourBottom[channel] : state.column.colourTop[channel];
        },
        [=](NumberDescription &description, const EdgeWalkSpanState &state) {
            description.toolTip = u"Level of % where "_s
                + nameOf(isLower ? state.lower : state.upper)
                + names.filled(u", the "_s + word + u" edge here, meets the {span}."_s);
            description.formula = names.boundFormula(state, bound, title, "%", "δ%");
            description.startFormula.clear();
        });
}

/// Δ% of a triangle's colour plane along the spans.
QString planeRate(const EdgeWalkNames &names)
{
    return planeSlope(names.isRow() ? u'x' : u'y', "A");
}

/// Whether the colours' change along a span is the plane's.
bool isPlanesRate(const EdgeWalkNames &names, const EdgeWalkStart &start)
{
    return names.form().rate == ColourRate::Plane && start.hasPlane;
}

/// Between equal bounds (R_T − R_B)/(y_T − y_B) is undefined, and no pixel uses it.
bool hasRate(const EdgeWalkNames &names, const EdgeWalkStart &start)
{
    return isPlanesRate(names, start) || !start.isPoint;
}

void specifyRate(const EdgeWalkNames &names, NumberDescription &description,
                 const EdgeWalkSpanState &state)
{
    if (isPlanesRate(names, state.start)) {
        description.formula = u"Δ% = "_s + planeRate(names);
        description.toolTip = "Change of % along the {span}, the plane's, the same in all of them.";
    } else if (state.start.isPoint) {
        description.formula.clear();
        description.toolTip = "None: {a}_{lo} = {a}_{hi}, there is nothing to share out.";
    } else {
        description.formula = "Δ% = (%_{hi} − %_{lo})/({a}_{hi} − {a}_{lo})";
        description.toolTip = "Change of % from sample to sample of the {span}.";
    }
    description = names.filled(std::move(description));
}

/// Whether each level is computed from the triangle's first vertex, not from the previous one.
bool isDirect(const EdgeWalkNames &names, const EdgeWalkStart &start)
{
    return names.form().walk == WalkForm::Direct && (start.hasPlane || start.isVertical);
}

/// The level at @ on the span.
QString directLevel(const EdgeWalkStart &start)
{
    return start.hasPlane ? u"%₀ + "_s + planeSlope(u'x', "A") + u"·(x − x₀) + Δ%·(@ − y₀)"_s
                          : u"%₀ + (@ − y₀)·Δ%"_s;
}

/// What the levels of a span start from.
QString startFormula(const EdgeWalkNames &names, const EdgeWalkStart &start, const QString &title)
{
    const QString covered = names.coveredSample(SpanBound::Lower, start.covered);
    const QString first = start.isClipped ? u"{a}_start"_s : covered;
    QString formula = "%_{lo} + (@ − {a}_{lo})·Δ%";
    if (!start.hasPreStep)
        formula = start.isClipped && hasRate(names, start) ? u"%_{lo} + ({a}_start − %1)·Δ%"_s.arg(
                      covered.endsWith(u'1') ? u'(' + covered + u')' : covered)
                                                           : u"%_{lo}"_s;
    else if (isDirect(names, start))
        formula = directLevel(start);
    else if (!hasRate(names, start))
        formula = "%_{lo}";
    return names.filled(title + formula.replace(u'@', first));
}

/// β of a level in float64: of a plane, or along a segment.
QString colourBias(const EdgeWalkSampleState &state)
{
    if (state.bias.toDouble() == 0)
        return u"0"_s;
    if (state.start.hasPlane)
        return u"1/(4·max(A, −A)·256²)"_s;
    return state.start.isVertical ? u"1/(4·256·(y₂ − y₀))"_s
        : state.start.isOnePoint  ? u"1/4"_s
                                  : u"1/(4·256·(x₂ − x₀))"_s;
}

void appendRamp(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names)
{
    const bool isPlanes = names.form().rate == ColourRate::Plane;
    appendChannels(
        table,
        names.filled(comparedNumber(
            "delta_%", "Δ%", "levels/{across}", "Change of % from sample to sample of the {span}.",
            u"Δ% = "_s
                + (isPlanes ? planeRate(names) : u"(%_{hi} − %_{lo})/({a}_{hi} − {a}_{lo})"_s),
            Group::ColourRates)),
        [names](const EdgeWalkSpanState &state, std::size_t channel) {
            return hasRate(names, state.start) ? state.column.colourRate[channel] : Quantity();
        },
        [=](NumberDescription &description, const EdgeWalkSpanState &state) {
            specifyRate(names, description, state);
        });
    const auto title = u"first % = "_s;
    appendChannels(
        table,
        names.filled(comparedNumber(
            "first_%", "first %", "levels",
            "Level of % at {a}_start, the {span}'s first drawn pixel.",
            startFormula(names, {.hasPlane = true, .isClipped = true}, title), Group::FirstColour)),
        [](const EdgeWalkSpanState &state, std::size_t channel) {
            return state.drawnSamples() > 0 ? state.column.firstColour[channel] : Quantity();
        },
        [=](NumberDescription &description, const EdgeWalkSpanState &state) {
            description.formula = startFormula(names, state.start, title);
        });
}

} // namespace

void appendEdgeWalkColours(NumberTable<EdgeWalkSpanState> &table, const EdgeWalkNames &names)
{
    appendBoundColours(table, names, SpanBound::Lower);
    appendBoundColours(table, names, SpanBound::Upper);
    appendRamp(table, names);
}

NumberTable<EdgeWalkSampleState> edgeWalkSampleNumbers(const EdgeWalkForm &form)
{
    const EdgeWalkNames names(form);
    NumberTable<EdgeWalkSampleState> table;
    const auto title = u"% ← "_s;
    appendChannels(
        table,
        {.id = "%",
         .title = "%",
         .unit = "levels",
         .toolTip = "Level of % at the sample.",
         .formula = "% ← %′ + Δ%",
         .startFormula = startFormula(names, {.hasPlane = true}, title),
         .group = Group::FirstColour,
         .comparison = Comparison::WithExact},
        [](const EdgeWalkSampleState &state, std::size_t channel) { return state.colour[channel]; },
        [=](NumberDescription &description, const EdgeWalkSampleState &state) {
            if (state.isFirst)
                description.formula = startFormula(names, state.start, title);
            else if (isDirect(names, state.start))
                description.formula
                    = names.filled(title + directLevel(state.start).replace(u'@', u"y"_s));
            description.startFormula.clear();
        });
    if (form.walk == WalkForm::Direct)
        table.push_back(
            {plainNumber("bias_colour", colourBiasTitle(), "levels",
                         "A quarter of the distance between the values that a level can have, "
                         "added before it is cut to a byte; 0 where it is computed in integers.",
                         {}, Group::FirstColour),
             [](const EdgeWalkSampleState &state) { return state.bias; },
             [](NumberDescription &description, const EdgeWalkSampleState &state) {
                 description.formula = colourBiasTitle() + u" = "_s + colourBias(state);
             }});
    return table;
}

} // namespace pixelplumb
