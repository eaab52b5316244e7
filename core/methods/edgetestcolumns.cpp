// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgetestcolumns.h"

#include "core/methods/channelcolumns.h"
#include "core/methods/edgetestnames.h"
#include "core/methods/placecolumns.h"

namespace pixelplumb {

namespace {

using Group = TraceColumnGroup;

QString px() { return QStringLiteral("px"); }
QString squarePx() { return QStringLiteral("px²"); }
QString levels() { return QStringLiteral("levels"); }

void appendVertices(std::vector<TraceColumn> &columns, const EdgeTestNames &names)
{
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        for (const char16_t axis : {u'x', u'y'})
            columns.push_back({.id = QChar(axis) + names.vertexId(vertex),
                               .title = QChar(axis) + names.vertex(vertex),
                               .unit = px(),
                               .toolTip = QStringLiteral("A vertex."),
                               .formula = {}});
    }
}

void appendColours(std::vector<TraceColumn> &columns, const EdgeTestNames &names)
{
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        appendChannels(columns,
                       {.id = u'%' + names.vertexId(vertex),
                        .title = u'%' + names.vertex(vertex),
                        .unit = levels(),
                        .toolTip = QStringLiteral("A level of a vertex."),
                        .formula = {}});
}

/// A, B, C of one edge, as the form computes them, and its value at the vertex that faces it.
void appendLine(std::vector<TraceColumn> &columns, const EdgeTestNames &names, std::size_t line)
{
    const EdgeTestForm &form = names.form();
    const auto add = [&](const char16_t *id, const char16_t *title, const char16_t *toolTip,
                         const QString &formula) {
        columns.push_back({.id = names.filledId(QString::fromUtf16(id), line),
                           .title = names.filled(QString::fromUtf16(title), line),
                           .unit = {},
                           .toolTip = names.filled(QString::fromUtf16(toolTip), line),
                           .formula = names.filled(formula, line)});
    };
    const auto scaled = [&](const QString &difference) {
        if (form.isBarycentric())
            return difference;
        const QString flipped = QStringLiteral("s{l}·(%1)").arg(difference);
        return form.line == LineForm::Solved ? flipped + QStringLiteral("/q{l}") : flipped;
    };
    if (form.line == LineForm::Solved)
        add(u"q{l}", u"q{l}",
            u"The determinant of the system; 1 where it is 0, and then c = 0 is chosen.",
            QStringLiteral("q{l} = x{from}·y{to} − y{from}·x{to}"));
    if (form.line == LineForm::CanonicalEnd) {
        add(u"u{l}", u"u{l}", u"x of the edge's end point that is smaller in (x, y) order, px.",
            {});
        add(u"v{l}", u"v{l}", u"y of the edge's end point that is smaller in (x, y) order, px.",
            {});
    }
    if (!form.isBarycentric())
        add(u"s{l}", u"s{l}", u"−1 where the edge's sides were exchanged to be positive inside.",
            {});
    add(u"a{l}", u"a{l}", u"Change of the edge function for each step of x.",
        QStringLiteral("a{l} = ") + scaled(QStringLiteral("y{to} − y{from}")));
    add(u"b{l}", u"b{l}", u"Change of the edge function for each step of y.",
        QStringLiteral("b{l} = ") + scaled(QStringLiteral("x{from} − x{to}")));
    if (form.line == LineForm::Absolute || form.line == LineForm::Solved)
        add(u"c{l}", u"c{l}", u"The edge function at (0, 0).",
            QStringLiteral("c{l} = ") + scaled(QStringLiteral("x{to}·y{from} − x{from}·y{to}")));
    const QString atOpposite = names.lineAt(QStringLiteral("x{opp}"), QStringLiteral("y{opp}"));
    if (form.isBarycentric())
        add(u"f{opp}", u"f{opp}", u"The edge function at the vertex that faces the edge.",
            QStringLiteral("f{opp} = ") + atOpposite);
    else
        add(u"F{l}", u"F{l}", u"The edge function at the vertex that faces the edge.",
            QStringLiteral("F{l} = ") + atOpposite);
}

void appendCramer(std::vector<TraceColumn> &columns)
{
    for (const char16_t vertex : {u'A', u'B'}) {
        for (const char16_t axis : {u'x', u'y'}) {
            const QString name = QStringLiteral("%1_%2C").arg(QChar(axis)).arg(QChar(vertex));
            columns.push_back(
                {.id = name,
                 .title = name,
                 .unit = px(),
                 .toolTip = QStringLiteral("A coordinate of %1 − C.").arg(QChar(vertex)),
                 .formula = QStringLiteral("%1 = %2_%3 − %2_C")
                                .arg(name)
                                .arg(QChar(axis))
                                .arg(QChar(vertex))});
        }
    }
    columns.push_back({.id = QStringLiteral("D"),
                       .title = QStringLiteral("D"),
                       .unit = squarePx(),
                       .toolTip = QStringLiteral("The determinant |A − C, B − C|."),
                       .formula = QStringLiteral("D = x_AC·y_BC − x_BC·y_AC")});
}

/// What the weights and levels change by.
void appendRates(std::vector<TraceColumn> &columns, const EdgeTestNames &names)
{
    for (const char16_t axis : {u'x', u'y'}) {
        const QChar coefficient = axis == u'x' ? u'a' : u'b';
        for (std::size_t line = 0; line < 3; ++line) {
            columns.push_back(
                {.id = names.filledId(QStringLiteral("delta_{w}_"), line) + QChar(axis),
                 .title = names.filled(QStringLiteral("Δ{w}_"), line) + QChar(axis),
                 .unit = {},
                 .toolTip
                 = QStringLiteral("Change of the weight for each step of %1.").arg(QChar(axis)),
                 .formula = names.filled(
                     QStringLiteral("Δ{w}_%1 = %2{l}/f{opp}").arg(QChar(axis)).arg(coefficient),
                     line)});
        }
    }
    for (const QChar axis : {u'x', u'y'})
        appendChannels(columns,
                       {.id = QStringLiteral("delta_%_") + axis,
                        .title = QStringLiteral("Δ%_") + axis,
                        .unit = QStringLiteral("levels/px"),
                        .toolTip = QStringLiteral("Change of % for each step of ") + axis + u'.',
                        .formula = QStringLiteral("Δ%_{} = Δα_{}·%_a + Δβ_{}·%_b + Δγ_{}·%_c")
                                       .replace(QStringLiteral("{}"), axis)});
}

} // namespace

std::vector<TraceColumn> edgeTestSetUpColumns(const EdgeTestForm &form)
{
    const EdgeTestNames names(form);
    std::vector<TraceColumn> columns;
    appendVertices(columns, names);
    if (form.inside == InsideTest::Cramer)
        appendCramer(columns);
    for (std::size_t line = 0; line < 3 && form.inside != InsideTest::Cramer; ++line)
        appendLine(columns, names, line);
    for (std::size_t line = 0; line < 3; ++line)
        columns.push_back({.id = names.filledId(QStringLiteral("tie{l}"), line),
                           .title = names.filled(QStringLiteral("tie{l}"), line),
                           .unit = {},
                           .toolTip = QStringLiteral(
                               "1: under the fill rule, a sample exactly on this edge is inside."),
                           .formula = {}});
    if (form.isBarycentric() && form.evaluation == Evaluation::Increments)
        appendRates(columns, names);
    appendColours(columns, names);
    return columns;
}

std::vector<TraceColumn> edgeTestSpanColumns(const EdgeTestForm &form)
{
    const EdgeTestNames names(form);
    const bool isRow = form.order == LoopOrder::RowByRow;
    const QChar across = isRow ? u'y' : u'x';
    const QChar along = isRow ? u'x' : u'y';
    std::vector<TraceColumn> columns
        = {triangleColumn(),
           {.id = across,
            .title = across,
            .unit = px(),
            .toolTip = isRow ? QStringLiteral("The row.") : QStringLiteral("The column."),
            .formula = {}},
           {.id = along + QStringLiteral("_min"),
            .title = along + QStringLiteral("_min"),
            .unit = px(),
            .toolTip = QStringLiteral("The first sample that is tested."),
            .formula = {},
            .group = Group::Span},
           {.id = along + QStringLiteral("_max"),
            .title = along + QStringLiteral("_max"),
            .unit = px(),
            .toolTip = QStringLiteral("The last sample that is tested."),
            .formula = {},
            .group = Group::Span}};
    if (form.evaluation == Evaluation::EverySample)
        return columns;
    if (!form.isBarycentric()) {
        for (std::size_t line = 0; line < 3; ++line)
            columns.push_back(
                {.id = names.filledId(QStringLiteral("e{l}"), line),
                 .title = names.filled(QStringLiteral("e{l}"), line),
                 .unit = squarePx(),
                 .toolTip = QStringLiteral("The edge function at the row's first sample."),
                 .formula = names.filled(QStringLiteral("e{l} ← e{l}′ + b{l}"), line),
                 .startFormula
                 = names.filled(QStringLiteral("e{l} = a{l}·x_min + b{l}·y + c{l}"), line),
                 .group = Group::Span,
                 .comparison = Comparison::WithExact});
        return columns;
    }
    for (std::size_t line = 0; line < 3; ++line)
        columns.push_back({.id = names.filledId(QStringLiteral("{w}_s"), line),
                           .title = names.filled(QStringLiteral("{w}_s"), line),
                           .unit = {},
                           .toolTip = QStringLiteral("The weight at the column's first sample."),
                           .formula = names.filled(QStringLiteral("{w}_s ← {w}_s′ + Δ{w}_x"), line),
                           .startFormula = names.filled(
                               QStringLiteral("{w}_s = (a{l}·x + b{l}·y_min + c{l})/f{opp}"), line),
                           .group = Group::Span,
                           .comparison = Comparison::WithExact});
    appendChannels(columns,
                   {.id = QStringLiteral("%_s"),
                    .title = QStringLiteral("%_s"),
                    .unit = levels(),
                    .toolTip = QStringLiteral("The level at the column's first sample."),
                    .formula = QStringLiteral("%_s ← %_s′ + Δ%_x"),
                    .startFormula = QStringLiteral("%_s = α_s·%_a + β_s·%_b + γ_s·%_c"),
                    .group = Group::FirstColour,
                    .comparison = Comparison::WithExact});
    return columns;
}

std::vector<TraceColumn> edgeTestSampleColumns(const EdgeTestForm &form)
{
    const EdgeTestNames names(form);
    std::vector<TraceColumn> columns;
    const bool hasIncrements = form.evaluation == Evaluation::Increments;
    const bool showsValues
        = !form.isBarycentric() || (form.inside != InsideTest::Cramer && !hasIncrements);
    for (std::size_t line = 0; line < 3 && showsValues; ++line) {
        const bool decides = !form.isBarycentric();
        columns.push_back(
            {.id = names.filledId(QStringLiteral("{value}"), line),
             .title = names.filled(QStringLiteral("{value}"), line),
             .unit = form.line == LineForm::Solved ? QString() : squarePx(),
             .toolTip = QStringLiteral("The edge function at the sample."),
             .formula = hasIncrements
                 ? names.filled(QStringLiteral("E{l} ← E{l}′ + a{l}"), line)
                 : names.filled(QStringLiteral("{value} = ")
                                    + names.lineAt(QStringLiteral("x"), QStringLiteral("y")),
                                line),
             .startFormula
             = hasIncrements ? names.filled(QStringLiteral("E{l} ← e{l}"), line) : QString(),
             .group = decides ? Group::Decision : Group::Span,
             .comparison = Comparison::WithExact});
    }
    for (std::size_t line = 0; line < 3 && form.isBarycentric(); ++line)
        columns.push_back(
            {.id = names.filledId(QStringLiteral("{w}"), line),
             .title = names.filled(QStringLiteral("{w}"), line),
             .unit = {},
             .toolTip = QStringLiteral("The weight of the vertex that faces the edge."),
             .formula = names.weightFormula(line),
             .startFormula
             = hasIncrements ? names.filled(QStringLiteral("{w} ← {w}_s"), line) : QString(),
             .group = Group::Decision,
             .comparison = Comparison::WithExact});
    const bool stepsColours = hasIncrements && form.isBarycentric();
    appendChannels(columns,
                   {.id = QStringLiteral("%"),
                    .title = QStringLiteral("%"),
                    .unit = levels(),
                    .toolTip = QStringLiteral("Level of % at the sample."),
                    .formula = names.levelFormula(),
                    .startFormula = stepsColours ? QStringLiteral("% ← %_s") : QString(),
                    .group = Group::FirstColour,
                    .comparison = Comparison::WithExact});
    return columns;
}

} // namespace pixelplumb
