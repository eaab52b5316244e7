// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonoutlinenumbers.h"

#include "core/methods/lines/linewords.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

NumberDescription outlineCount(const QString &id, const QString &title, const QString &toolTip)
{
    return plainNumber(id, title, {}, toolTip);
}

} // namespace

NumberTable<PolygonOutlineSetUp> polygonOutlineSetUpNumbers()
{
    return {{outlineCount("contours", "contours", "Closed chains of edges: outlines and holes."),
             [](const PolygonOutlineSetUp &setUp) {
                 return Quantity::integer(Int128(setUp.contourCount));
             }},
            {outlineCount("edges", "edges", "Edges of all contours: as many lines."),
             [](const PolygonOutlineSetUp &setUp) {
                 return Quantity::integer(Int128(setUp.edgeCount));
             }}};
}

NumberTable<PolygonOutlineState> polygonOutlineNumbers()
{
    NumberTable<PolygonOutlineState> table
        = {{outlineCount("edge", "e",
                         "The edge whose line this is: its place in the contours, from 0."),
            [](const PolygonOutlineState &step) { return Quantity::integer(Int128(step.edge)); }}};
    for (const NumberRow<DecisionState> &row : decisionNumbers())
        table.push_back({row.description, row.read, row.specify});
    for (const NumberRow<DecisionSetUpState> &row : symmetricSetUpNumbers()) {
        NumberDescription ofLine = row.description;
        ofLine.group = NumberGroup::Span;
        table.push_back({ofLine, [read = row.read](const PolygonOutlineState &step) {
                             return read(step.line);
                         }});
    }
    return table;
}

void tellLine(StepWords &words, const PolygonOutlineState &state)
{
    tellLine(words, static_cast<const DecisionState &>(state));
    StepWords line;
    if (!state.isLedByDecision())
        tellLine(line, state.line);
    words.sentence = u"Edge %1. %2 %3"_s.arg(state.edge).arg(line.sentence, words.sentence);
    words.sentence.replace(u"  "_s, u" "_s);
}

} // namespace pixelplumb
