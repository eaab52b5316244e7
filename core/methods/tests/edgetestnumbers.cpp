// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/edgetestnumbers.h"

#include "core/methods/tests/boxnumbers.h"
#include "core/methods/tests/edgetestnames.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"
#include "core/scan/degeneratesegment.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// What decides a sample of a triangle without area: no edge does.
NumberRow<EdgeTestSampleState> segmentNumber()
{
    using State = EdgeTestSampleState;
    const auto segmentOf
        = [](const State &state) { return DegenerateSegment(Triangle{state.vertices}); };
    return {plainNumber(
                "segment", "d", "px²",
                "Twice the area that the sample makes with the segment of a triangle without an "
                "area: 0 where the segment's line passes through it. None of other triangles.",
                {}, Group::Span),
            [segmentOf](const State &state) {
                if (!state.ofSegment)
                    return Quantity();
                const DegenerateSegment segment = segmentOf(state);
                return Quantity::rational(
                    doubledArea(segment.first().position, segment.last().position, state.sample),
                    squareUnitsPerPixel);
            },
            [segmentOf](NumberDescription &number, const State &state) {
                if (!state.ofSegment)
                    return;
                const DegenerateSegment segment = segmentOf(state);
                const LatticePoint first = segment.first().position;
                const LatticePoint last = segment.last().position;
                number.formula = u"d = "_s + differenceText(last.x, first.x)
                    + u"·(y − %1) − "_s.arg(operand(pixels(first.y)))
                    + differenceText(last.y, first.y)
                    + u"·(x − %1)"_s.arg(operand(pixels(first.x)));
            }};
}

/// What Cramer's rule asks in place of w.
NumberRow<EdgeTestSampleState> sumNumber()
{
    return {comparedNumber("s", "s", {}, "u + v: above 1 beyond the edge AB.", "s = u + v",
                           Group::Decision),
            [](const EdgeTestSampleState &state) { return state.sum; }};
}

/// Along the segment of a triangle without an area, whose tests are all 0/0.
QString segmentFormula(const EdgeTestNames &names, const EdgeTestSampleState &sample)
{
    const std::array<int, 3> order = sortedByColumn(Triangle{sample.vertices});
    const auto first = std::size_t(order[0]), last = std::size_t(order[2]);
    const LatticePoint &from = sample.vertices[first].position;
    const LatticePoint &to = sample.vertices[last].position;
    QString formula = from == to ? u"% = %#"_s : u"% = %# + (@ − @#)·(%& − %#)/(@& − @#)"_s;
    return formula.replace(u'@', from.x == to.x ? u'y' : u'x')
        .replace(u'#', names.vertex(first))
        .replace(u'&', names.vertex(last));
}

} // namespace

NumberTable<EdgeTestSpanState> edgeTestSpanNumbers(const EdgeTestForm &form)
{
    using State = EdgeTestSpanState;
    const EdgeTestNames names(form);
    const bool isRow = form.order == LoopOrder::RowByRow;
    const QChar across = isRow ? u'y' : u'x';
    const QChar along = isRow ? u'x' : u'y';
    NumberTable<EdgeTestSpanState> table
        = {{triangleNumber(),
            [](const State &state) { return Quantity::integer(Int128(state.primitive)); }},
           {plainNumber(across, across, "px", isRow ? u"The row."_s : u"The column."_s),
            [](const State &state) { return Quantity::integer(state.coordinate); }}};
    appendExtent(table, form, along, "sample", Group::Span);
    if (form.evaluation == Evaluation::EverySample)
        return table;
    if (!form.isBarycentric()) {
        for (std::size_t line = 0; line < 3; ++line)
            table.push_back(
                {{.id = names.filledId("e{l}", line),
                  .title = names.filled("e{l}", line),
                  .unit = "px²",
                  .toolTip
                  = names.filled("The edge function of {edge} at the row's first sample.", line),
                  .formula = names.filled("e{l} ← e{l}′ + b{l}", line),
                  .startFormula = names.filled("e{l} = a{l}·x_min + b{l}·y + c{l}", line),
                  .group = Group::Span,
                  .comparison = Comparison::WithExact},
                 [line](const State &state) { return state.value[line]; }});
        return table;
    }
    for (std::size_t line = 0; line < 3; ++line)
        table.push_back(
            {{.id = names.filledId("{w}_s", line),
              .title = names.filled("{w}_s", line),
              .toolTip
              = names.filled("The weight of vertex {facing} at the column's first sample.", line),
              .formula = names.filled("{w}_s ← {w}_s′ + Δ{w}_x", line),
              .startFormula = names.filled("{w}_s = (a{l}·x + b{l}·y_min + c{l})/f{opp}", line),
              .group = Group::Span,
              .comparison = Comparison::WithExact},
             [line](const State &state) { return state.weight[line]; }});
    appendChannels(table,
                   {.id = "%_s",
                    .title = "%_s",
                    .unit = "levels",
                    .toolTip = "Level of % at the column's first sample.",
                    .formula = "%_s ← %_s′ + Δ%_x",
                    .startFormula = "%_s = α_s·%_a + β_s·%_b + γ_s·%_c",
                    .group = Group::FirstColour,
                    .comparison = Comparison::WithExact},
                   [](const State &state, std::size_t channel) { return state.colour[channel]; });
    return table;
}

NumberTable<EdgeTestSampleState> edgeTestSampleNumbers(const EdgeTestForm &form)
{
    using State = EdgeTestSampleState;
    const EdgeTestNames names(form);
    NumberTable<EdgeTestSampleState> table;
    const bool hasIncrements = form.evaluation == Evaluation::Increments;
    const bool showsValues
        = !form.isBarycentric() || (form.inside != InsideTest::Cramer && !hasIncrements);
    for (std::size_t line = 0; line < 3 && showsValues; ++line) {
        const bool decides = !form.isBarycentric();
        table.push_back(
            {{.id = names.filledId("{value}", line),
              .title = names.filled("{value}", line),
              .unit = form.line == LineForm::Solved ? QString() : "px²",
              .toolTip = names.filled("The edge function of {edge} at the sample.", line),
              .formula = hasIncrements
                  ? names.filled("E{l} ← E{l}′ + a{l}", line)
                  : names.filled(u"{value} = "_s + names.lineAt("x", "y"), line),
              .startFormula = hasIncrements ? names.filled("E{l} ← e{l}", line) : QString(),
              .group = decides ? Group::Decision : Group::Span,
              .comparison = Comparison::WithExact},
             [line](const State &state) { return state.value[line]; }});
    }
    const bool isCramer = form.inside == InsideTest::Cramer;
    for (std::size_t line = 0; line < 3 && form.isBarycentric(); ++line) {
        if (isCramer && line == 2)
            table.push_back(sumNumber());
        table.push_back(
            {{.id = names.filledId("{w}", line),
              .title = names.filled("{w}", line),
              .toolTip = names.filled("The weight of vertex {facing} at the sample.", line),
              .formula = names.weightFormula(line),
              .startFormula = hasIncrements ? names.filled("{w} ← {w}_s", line) : QString(),
              // Of w only the colours depend.
              .group = isCramer && line == 2 ? Group::FirstColour : Group::Decision,
              .comparison = Comparison::WithExact},
             [line](const State &state) { return state.weight[line]; }});
    }
    table.push_back(segmentNumber());
    const bool stepsColours = hasIncrements && form.isBarycentric();
    appendChannels(
        table,
        {.id = "%",
         .title = "%",
         .unit = "levels",
         .toolTip = "Level of % at the sample.",
         .formula = names.levelFormula(),
         .startFormula = stepsColours ? u"% ← %_s"_s : QString(),
         .group = Group::FirstColour,
         .comparison = Comparison::WithExact},
        [](const State &state, std::size_t channel) { return state.colour[channel]; },
        [names](NumberDescription &description, const State &state) {
            if (!state.ofSegment)
                return;
            description.formula = segmentFormula(names, state);
            description.startFormula.clear();
        });
    return table;
}

} // namespace pixelplumb
