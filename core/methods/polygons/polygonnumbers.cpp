// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonnumbers.h"

#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// A shown crossing with its edge.
struct ShownCrossing {
    const Crossing<AnyArithmetic> &crossing;
    const CrossedEdge &edge;
};

/// "_L", "₀": the ending of the names of a crossing's numbers.
QString subscriptAt(PolygonForm form, std::size_t place)
{
    if (isInTriangles(form))
        return place == 0 ? u"_L"_s : u"_R"_s;
    return QChar(u'₀' + char16_t(place));
}

/// Appends the numbers of the crossing at this place; % stands for the subscript in titles, # for
/// it in identifiers. `edges` is what the edges are counted in. An edge's ends have no numbers: the
/// formulas name them themselves.
void appendCrossing(NumberTable<PolygonRowState> &table, PolygonForm form, std::size_t place,
                    const QString &id, const QString &edges)
{
    using Shown = ShownCrossing;
    const NumberTable<Shown> pattern = {
        {comparedNumber("x_#", "x%", "px", "Where edge e% meets the row; crossings ascend in x.",
                        "x% = b% + t%·m%", Group::Span),
         [](const Shown &shown) { return shown.crossing.x; }},
        {plainNumber("edge_#", "e%", {},
                     u"The edge that crosses at x%: its place in %1, from 0."_s.arg(edges), {},
                     Group::Span),
         [](const Shown &shown) { return Quantity::integer(Int128(shown.crossing.edge)); }},
        {comparedNumber(
             "base_#", "b%", "px",
             "x of edge e% on the row before; on its first row, x of its end of smaller y.", {},
             Group::Decision),
         [](const Shown &shown) { return shown.crossing.base; },
         [form](NumberDescription &number, const Shown &shown) {
             const CrossedEdge &edge = shown.edge;
             if (edge.begins)
                 number.formula = u"b% = "_s + term(pixels(edge.low.x));
             else if (edge.before)
                 number.formula = u"b% = x%1′"_s.arg(subscriptAt(form, *edge.before));
         }},
        {comparedNumber(
             "rise_#", "t%", "rows",
             "Rows from b% to this row: 1; on the first row of edge e%, the pre-step from "
             "its end of smaller y.",
             {}, Group::Decision),
         [](const Shown &shown) { return shown.crossing.rise; },
         [](NumberDescription &number, const Shown &shown) {
             number.formula = shown.edge.begins ? u"t% = y − "_s + operand(pixels(shown.edge.low.y))
                                                : u"t% = 1"_s;
         }},
        {comparedNumber("slope_#", "m%", "px/row", "What x of edge e% gains from row to row.", {},
                        Group::Decision),
         [](const Shown &shown) { return shown.crossing.slope; },
         [](NumberDescription &number, const Shown &shown) {
             const CrossedEdge &edge = shown.edge;
             number.formula = u"m% = "_s + differenceText(edge.high.x, edge.low.x) + u'/'
                 + differenceText(edge.high.y, edge.low.y);
         }},
    };
    const auto named = [subscript = subscriptAt(form, place)](NumberDescription &number) {
        number.title.replace(u"%"_s, subscript);
        number.formula.replace(u"%"_s, subscript);
        number.toolTip.replace(u"%"_s, subscript);
    };
    const auto shownIn = [place](const PolygonRowState &state) {
        return Shown{state.crossings[place], state.edges[place]};
    };
    for (const NumberRow<Shown> &row : pattern) {
        NumberDescription number = row.description;
        number.id.replace(u'#', id);
        named(number);
        table.push_back(
            {number,
             [place, shownIn, read = row.read](const PolygonRowState &state) {
                 return place < state.crossings.size() ? read(shownIn(state)) : Quantity();
             },
             [=, specify = row.specify](NumberDescription &inRow, const PolygonRowState &state) {
                 if (!specify || place >= state.crossings.size())
                     return;
                 specify(inRow, shownIn(state));
                 named(inRow);
             }});
    }
}

NumberDescription count(const QString &id, const QString &title, const QString &toolTip)
{
    return plainNumber(id, title, {}, toolTip);
}

/// Where edges cross, and what moving these corners onto the lattice does.
void appendCrossingPoints(NumberTable<PolygonSetUp> &numbers)
{
    numbers.push_back(
        {count("crossing_points", "crossings",
               "Corners of triangles where edges of the polygon cross, beside its own vertices."),
         [](const PolygonSetUp &setUp) { return Quantity::integer(Int128(setUp.crossingCount)); }});
    numbers.push_back({plainNumber("moved", "moved", "px",
                                   "The farthest that a crossing was moved to the nearest multiple "
                                   "of 1/256 px: a sample so near to an edge may be wrong."),
                       [](const PolygonSetUp &setUp) { return Quantity::of(setUp.largestMove); }});
}

} // namespace

NumberTable<PolygonSetUp> polygonSetUpNumbers(PolygonForm form)
{
    NumberTable<PolygonSetUp> numbers = {
        {count("contours", "contours", "Closed chains of edges: outlines and holes."),
         [](const PolygonSetUp &setUp) { return Quantity::integer(Int128(setUp.contourCount)); }},
        {count("edges", "edges", "Edges of all contours."),
         [](const PolygonSetUp &setUp) { return Quantity::integer(Int128(setUp.edgeCount)); }},
        {count("horizontal", "horizontal",
               "Edges that no row crosses, because they are horizontal; they are not in the edge "
               "table."),
         [](const PolygonSetUp &setUp) {
             return Quantity::integer(Int128(setUp.horizontalEdges));
         }},
    };
    if (form == PolygonForm::Chords)
        numbers.push_back({count("curves", "curves", "Bézier pieces, whose chords the edges are."),
                           [](const PolygonSetUp &setUp) {
                               return Quantity::integer(Int128(setUp.curveCount));
                           }});
    if (isInTriangles(form))
        numbers.push_back(
            {count("triangles", "triangles", "Triangles that the polygon is broken into."),
             [](const PolygonSetUp &setUp) {
                 return Quantity::integer(Int128(setUp.pieceCount));
             }});
    if (form == PolygonForm::CrossingTriangles)
        appendCrossingPoints(numbers);
    numbers.push_back(
        {plainNumber("first_row", "y_first", "px", "The first row that an edge crosses."),
         [](const PolygonSetUp &setUp) { return Quantity::integer(setUp.firstRow); }});
    numbers.push_back(
        {plainNumber("last_row", "y_last", "px", "The last row that an edge crosses."),
         [](const PolygonSetUp &setUp) { return Quantity::integer(setUp.endRow - 1); }});
    return numbers;
}

NumberTable<PolygonRowState> polygonRowNumbers(PolygonForm form)
{
    NumberTable<PolygonRowState> numbers = {
        {count("polygon", "poly", "The primitive's place in drawing order, from 0."),
         [](const PolygonRowState &row) { return Quantity::integer(Int128(row.primitive)); }},
        {plainNumber("y", "y", "px", "The row."),
         [](const PolygonRowState &row) { return Quantity::integer(row.y); }},
    };
    if (isInTriangles(form)) {
        numbers.push_back(
            {count("triangle", "tri",
                   "Which of the polygon's triangles the row belongs to, from 0."),
             [](const PolygonRowState &row) { return Quantity::integer(row.piece); }});
        numbers.push_back(
            {plainNumber("pixels", "px", {},
                         "Pixels written in this row of the triangle, inside the frame: from ⌈x_L⌉ "
                         "to ⌈x_R⌉ − 1.",
                         {}, Group::Span),
             [](const PolygonRowState &row) { return Quantity::integer(row.drawnSamples()); }});
        const QString edges = "the row's triangle";
        appendCrossing(numbers, form, 0, "L", edges);
        appendCrossing(numbers, form, 1, "R", edges);
        return numbers;
    }
    numbers.push_back(
        {plainNumber("active", "n", {},
                     u"Active edges: those that the row crosses. The first %1 stand in the table."_s
                         .arg(shownCrossings(form)),
                     {}, Group::Span),
         [](const PolygonRowState &row) { return Quantity::integer(Int128(row.crossingCount)); }});
    for (std::size_t i = 0; i < shownCrossings(form); ++i)
        appendCrossing(numbers, form, i, QString::number(i), "the contours");
    return numbers;
}

NumberTable<PolygonSampleState> polygonSampleNumbers(PolygonForm form)
{
    if (isInTriangles(form))
        return {};
    return {
        {comparedNumber(
             "downward", "d", {},
             "Crossings at or to the left of the sample by edges that run downward; they "
             "have the sample at their left.",
             {}, Group::Decision),
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.downward); }},
        {comparedNumber("upward", "u", {},
                        "Crossings at or to the left of the sample by edges that run upward; they "
                        "have the sample at their right.",
                        {}, Group::Decision),
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.upward); }},
        {comparedNumber("crossings", "c", {},
                        "Crossings of the row at or to the left of the sample.", "c = d + u",
                        Group::Decision),
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.crossings); }},
        {comparedNumber("parity", "p", {},
                        "Their parity; by even-odd the sample is inside where it is 1.",
                        "p = c mod 2", Group::Decision),
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.crossings % 2); }},
        {comparedNumber("winding", "w", {},
                        "The winding number, 1 inside a contour that turns counter-clockwise; by "
                        "non-zero the sample is inside where it is not 0.",
                        "w = d − u", Group::Decision),
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.winding); }},
    };
}

} // namespace pixelplumb
