// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonnumbers.h"

#include "core/methods/words/formulatext.h"

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
        return place == 0 ? QStringLiteral("_L") : QStringLiteral("_R");
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
        {{.id = QStringLiteral("x_#"),
          .title = QStringLiteral("x%"),
          .unit = QStringLiteral("px"),
          .toolTip = QStringLiteral("Where edge e% meets the row; crossings ascend in x."),
          .formula = QStringLiteral("x% = b% + t%·m%"),
          .group = Group::Span,
          .comparison = Comparison::WithExact},
         [](const Shown &shown) { return shown.crossing.x; }},
        {{.id = QStringLiteral("edge_#"),
          .title = QStringLiteral("e%"),
          .unit = {},
          .toolTip
          = QStringLiteral("The edge that crosses at x%: its place in %1, from 0.").arg(edges),
          .formula = {},
          .group = Group::Span},
         [](const Shown &shown) { return Quantity::integer(Int128(shown.crossing.edge)); }},
        {{.id = QStringLiteral("base_#"),
          .title = QStringLiteral("b%"),
          .unit = QStringLiteral("px"),
          .toolTip = QStringLiteral("x of edge e% on the row before; on its first row, x of its "
                                    "end of smaller y."),
          .formula = {},
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const Shown &shown) { return shown.crossing.base; },
         [form](NumberDescription &number, const Shown &shown) {
             const CrossedEdge &edge = shown.edge;
             if (edge.begins)
                 number.formula = QStringLiteral("b% = ") + term(pixels(edge.low.x));
             else if (edge.before)
                 number.formula = QStringLiteral("b% = x%1′").arg(subscriptAt(form, *edge.before));
         }},
        {{.id = QStringLiteral("rise_#"),
          .title = QStringLiteral("t%"),
          .unit = QStringLiteral("rows"),
          .toolTip = QStringLiteral("Rows from b% to this row: 1; on the first row of edge e%, "
                                    "the pre-step from its end of smaller y."),
          .formula = {},
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const Shown &shown) { return shown.crossing.rise; },
         [](NumberDescription &number, const Shown &shown) {
             number.formula = shown.edge.begins
                 ? QStringLiteral("t% = y − ") + operand(pixels(shown.edge.low.y))
                 : QStringLiteral("t% = 1");
         }},
        {{.id = QStringLiteral("slope_#"),
          .title = QStringLiteral("m%"),
          .unit = QStringLiteral("px/row"),
          .toolTip = QStringLiteral("What x of edge e% gains from row to row."),
          .formula = {},
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const Shown &shown) { return shown.crossing.slope; },
         [](NumberDescription &number, const Shown &shown) {
             const CrossedEdge &edge = shown.edge;
             number.formula = QStringLiteral("m% = ") + differenceText(edge.high.x, edge.low.x)
                 + u'/' + differenceText(edge.high.y, edge.low.y);
         }},
    };
    const auto named = [subscript = subscriptAt(form, place)](NumberDescription &number) {
        number.title.replace(QStringLiteral("%"), subscript);
        number.formula.replace(QStringLiteral("%"), subscript);
        number.toolTip.replace(QStringLiteral("%"), subscript);
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
    return {.id = id, .title = title, .unit = {}, .toolTip = toolTip, .formula = {}};
}

/// Where edges cross, and what moving these corners onto the lattice does.
void appendCrossingPoints(NumberTable<PolygonSetUp> &numbers)
{
    numbers.push_back(
        {count(QStringLiteral("crossing_points"), QStringLiteral("crossings"),
               QStringLiteral("Corners of triangles where edges of the polygon cross, "
                              "beside its own vertices.")),
         [](const PolygonSetUp &setUp) { return Quantity::integer(Int128(setUp.crossingCount)); }});
    numbers.push_back({{.id = QStringLiteral("moved"),
                        .title = QStringLiteral("moved"),
                        .unit = QStringLiteral("px"),
                        .toolTip = QStringLiteral("The farthest that a crossing was moved to the "
                                                  "nearest multiple of 1/256 px: a sample so near "
                                                  "to an edge may be wrong."),
                        .formula = {}},
                       [](const PolygonSetUp &setUp) { return Quantity::of(setUp.largestMove); }});
}

} // namespace

NumberTable<PolygonSetUp> polygonSetUpNumbers(PolygonForm form)
{
    NumberTable<PolygonSetUp> numbers = {
        {count(QStringLiteral("contours"), QStringLiteral("contours"),
               QStringLiteral("Closed chains of edges: outlines and holes.")),
         [](const PolygonSetUp &setUp) { return Quantity::integer(Int128(setUp.contourCount)); }},
        {count(QStringLiteral("edges"), QStringLiteral("edges"),
               QStringLiteral("Edges of all contours.")),
         [](const PolygonSetUp &setUp) { return Quantity::integer(Int128(setUp.edgeCount)); }},
        {count(
             QStringLiteral("horizontal"), QStringLiteral("horizontal"),
             QStringLiteral("Edges that no row crosses, because they are horizontal; they are not "
                            "in the edge table.")),
         [](const PolygonSetUp &setUp) {
             return Quantity::integer(Int128(setUp.horizontalEdges));
         }},
    };
    if (form == PolygonForm::Chords)
        numbers.push_back({count(QStringLiteral("curves"), QStringLiteral("curves"),
                                 QStringLiteral("Bézier pieces, whose chords the edges are.")),
                           [](const PolygonSetUp &setUp) {
                               return Quantity::integer(Int128(setUp.curveCount));
                           }});
    if (isInTriangles(form))
        numbers.push_back({count(QStringLiteral("triangles"), QStringLiteral("triangles"),
                                 QStringLiteral("Triangles that the polygon is broken into.")),
                           [](const PolygonSetUp &setUp) {
                               return Quantity::integer(Int128(setUp.pieceCount));
                           }});
    if (form == PolygonForm::CrossingTriangles)
        appendCrossingPoints(numbers);
    numbers.push_back(
        {{.id = QStringLiteral("first_row"),
          .title = QStringLiteral("y_first"),
          .unit = QStringLiteral("px"),
          .toolTip = QStringLiteral("The first row that an edge crosses."),
          .formula = {}},
         [](const PolygonSetUp &setUp) { return Quantity::integer(setUp.firstRow); }});
    numbers.push_back(
        {{.id = QStringLiteral("last_row"),
          .title = QStringLiteral("y_last"),
          .unit = QStringLiteral("px"),
          .toolTip = QStringLiteral("The last row that an edge crosses."),
          .formula = {}},
         [](const PolygonSetUp &setUp) { return Quantity::integer(setUp.endRow - 1); }});
    return numbers;
}

NumberTable<PolygonRowState> polygonRowNumbers(PolygonForm form)
{
    NumberTable<PolygonRowState> numbers = {
        {count(QStringLiteral("polygon"), QStringLiteral("poly"),
               QStringLiteral("The primitive's place in drawing order, from 0.")),
         [](const PolygonRowState &row) { return Quantity::integer(Int128(row.primitive)); }},
        {{.id = QStringLiteral("y"),
          .title = QStringLiteral("y"),
          .unit = QStringLiteral("px"),
          .toolTip = QStringLiteral("The row."),
          .formula = {}},
         [](const PolygonRowState &row) { return Quantity::integer(row.y); }},
    };
    if (isInTriangles(form)) {
        numbers.push_back(
            {count(QStringLiteral("triangle"), QStringLiteral("tri"),
                   QStringLiteral("Which of the polygon's triangles the row belongs to, from 0.")),
             [](const PolygonRowState &row) { return Quantity::integer(row.piece); }});
        numbers.push_back(
            {{.id = QStringLiteral("pixels"),
              .title = QStringLiteral("px"),
              .unit = {},
              .toolTip = QStringLiteral("Pixels written in this row of the triangle, "
                                        "inside the frame: from ⌈x_L⌉ to ⌈x_R⌉ − 1."),
              .formula = {},
              .group = Group::Span},
             [](const PolygonRowState &row) { return Quantity::integer(row.drawnSamples()); }});
        const QString edges = QStringLiteral("the row's triangle");
        appendCrossing(numbers, form, 0, QStringLiteral("L"), edges);
        appendCrossing(numbers, form, 1, QStringLiteral("R"), edges);
        return numbers;
    }
    numbers.push_back(
        {{.id = QStringLiteral("active"),
          .title = QStringLiteral("n"),
          .unit = {},
          .toolTip = QStringLiteral("Active edges: those that the row crosses. The "
                                    "first %1 stand in the table.")
                         .arg(shownCrossings(form)),
          .formula = {},
          .group = Group::Span},
         [](const PolygonRowState &row) { return Quantity::integer(Int128(row.crossingCount)); }});
    for (std::size_t i = 0; i < shownCrossings(form); ++i)
        appendCrossing(numbers, form, i, QString::number(i), QStringLiteral("the contours"));
    return numbers;
}

NumberTable<PolygonSampleState> polygonSampleNumbers(PolygonForm form)
{
    if (isInTriangles(form))
        return {};
    return {
        {{.id = QStringLiteral("downward"),
          .title = QStringLiteral("d"),
          .unit = {},
          .toolTip = QStringLiteral("Crossings at or to the left of the sample by edges that run "
                                    "downward; they have the sample at their left."),
          .formula = {},
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.downward); }},
        {{.id = QStringLiteral("upward"),
          .title = QStringLiteral("u"),
          .unit = {},
          .toolTip = QStringLiteral("Crossings at or to the left of the sample by edges that run "
                                    "upward; they have the sample at their right."),
          .formula = {},
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.upward); }},
        {{.id = QStringLiteral("crossings"),
          .title = QStringLiteral("c"),
          .unit = {},
          .toolTip = QStringLiteral("Crossings of the row at or to the left of the sample."),
          .formula = QStringLiteral("c = d + u"),
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.crossings); }},
        {{.id = QStringLiteral("parity"),
          .title = QStringLiteral("p"),
          .unit = {},
          .toolTip
          = QStringLiteral("Their parity; by even-odd the sample is inside where it is 1."),
          .formula = QStringLiteral("p = c mod 2"),
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.crossings % 2); }},
        {{.id = QStringLiteral("winding"),
          .title = QStringLiteral("w"),
          .unit = {},
          .toolTip
          = QStringLiteral("The winding number, 1 inside a contour that turns counter-clockwise; "
                           "by non-zero the sample is inside where it is not 0."),
          .formula = QStringLiteral("w = d − u"),
          .group = Group::Decision,
          .comparison = Comparison::WithExact},
         [](const PolygonSampleState &sample) { return Quantity::integer(sample.winding); }},
    };
}

} // namespace pixelplumb
