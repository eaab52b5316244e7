// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/boxnumbers.h"
#include "core/methods/tests/edgetestnames.h"
#include "core/methods/tests/edgetestnumbers.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/placenumbers.h"

#include <functional>
#include <utility>

namespace pixelplumb {

namespace {

void appendVertices(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names)
{
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        for (const auto &[axis, coordinate] :
             {std::pair(u'x', &EdgeTestSetUpState::x), std::pair(u'y', &EdgeTestSetUpState::y)})
            table.push_back(
                {plainNumber(QChar(axis) + names.vertexId(vertex),
                             QChar(axis) + names.vertex(vertex), "px",
                             u"%1 of vertex %2, from the centre of pixel (0, 0)."_s.arg(QChar(axis))
                                 .arg(names.vertexName(vertex))),
                 [vertex, coordinate = coordinate](const EdgeTestSetUpState &state) {
                     return (state.*coordinate)[vertex];
                 }});
    }
}

void appendColours(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names)
{
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        appendChannels(
            table,
            plainNumber(u'%' + names.vertexId(vertex), u'%' + names.vertex(vertex), "levels",
                        u"Level of % at vertex "_s + names.vertexName(vertex) + u'.'),
            [vertex](const EdgeTestSetUpState &state, std::size_t channel) {
                return Quantity::integer(state.vertices[vertex].colour.channels[channel]);
            });
}

/// A line through (0, 0) has determinant 0: the solved form then takes c = 0 and does not divide.
void specifyThroughOrigin(NumberDescription &number, const QString &divisor)
{
    if (!number.formula.contains(divisor))
        return;
    number.formula.remove(divisor);
    number.toolTip += u" The line passes through (0, 0), the determinant is 0: c = 0 "
                      "is chosen, and nothing is divided."_s;
}

/// A, B, C of one edge, as the form computes them, and its value at the vertex that faces it.
void appendLine(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names,
                std::size_t line)
{
    const EdgeTestForm &form = names.form();
    const QString divisor = names.filled("/q{l}", line);
    const auto add = [&](const char16_t *name, const char16_t *toolTip, const QString &formula,
                         Quantity EdgeTestLineState::*member) {
        table.push_back(
            {comparedNumber(names.filledId(QString::fromUtf16(name), line),
                            names.filled(QString::fromUtf16(name), line), {},
                            names.filled(QString::fromUtf16(toolTip), line),
                            names.filled(formula, line)),
             [line, member](const EdgeTestSetUpState &state) { return state.lines[line].*member; },
             [line, divisor](NumberDescription &number, const EdgeTestSetUpState &state) {
                 if (state.lines[line].passesOrigin())
                     specifyThroughOrigin(number, divisor);
             }});
    };
    const auto scaled = [&](const QString &difference) {
        if (form.isBarycentric())
            return difference;
        const QString flipped = u"s{l}·(%1)"_s.arg(difference);
        return form.line == LineForm::Solved ? flipped + divisor : flipped;
    };
    if (form.line == LineForm::Solved)
        add(u"q{l}",
            u"The determinant of the system for edge {edge}; 0 where its line passes through "
            u"(0, 0): then c = 0 is chosen, and nothing is divided.",
            "q{l} = x{from}·y{to} − y{from}·x{to}", &EdgeTestLineState::determinant);
    if (form.line == LineForm::CanonicalEnd) {
        add(u"u{l}", u"x of the end of edge {edge} that is smaller in (x, y) order, px.", {},
            &EdgeTestLineState::u);
        add(u"v{l}", u"y of the end of edge {edge} that is smaller in (x, y) order, px.", {},
            &EdgeTestLineState::v);
    }
    if (!form.isBarycentric()) {
        const auto unflipped = [&](const QString &difference) {
            return u'(' + difference + u')' + (form.line == LineForm::Solved ? divisor : QString());
        };
        const QString side = names.lineAt("x{opp}", "y{opp}")
                                 .replace(u"a{l}"_s, unflipped("y{to} − y{from}"))
                                 .replace(u"b{l}"_s, unflipped("x{from} − x{to}"))
                                 .replace(u"c{l}"_s, unflipped("x{to}·y{from} − x{from}·y{to}"));
        add(u"sidedness{l}",
            u"The edge function of {edge} at vertex {facing}, which faces it: below 0 the sides "
            u"are "
            u"to be exchanged.",
            u"sidedness{l} = "_s + side, &EdgeTestLineState::sidedness);
        add(u"s{l}", u"−1 where the sides of edge {edge} were exchanged to be positive inside.",
            "s{l} = −1 if sidedness{l} < 0, else 1", &EdgeTestLineState::sign);
    }
    add(u"a{l}", u"Change of the edge function of {edge} for each step of x.",
        u"a{l} = "_s + scaled("y{to} − y{from}"), &EdgeTestLineState::a);
    add(u"b{l}", u"Change of the edge function of {edge} for each step of y.",
        u"b{l} = "_s + scaled("x{from} − x{to}"), &EdgeTestLineState::b);
    if (form.line == LineForm::Absolute || form.line == LineForm::Solved)
        add(u"c{l}", u"The edge function of {edge} at (0, 0).",
            u"c{l} = "_s + scaled("x{to}·y{from} − x{from}·y{to}"), &EdgeTestLineState::c);
    const QString atOpposite = names.lineAt("x{opp}", "y{opp}");
    if (form.isBarycentric())
        add(u"f{opp}", u"The edge function of {edge} at vertex {facing}, which faces it.",
            u"f{opp} = "_s + atOpposite, &EdgeTestLineState::atOpposite);
    else
        add(u"F{l}", u"The edge function of {edge} at vertex {facing}, which faces it.",
            u"F{l} = "_s + atOpposite, &EdgeTestLineState::atOpposite);
}

void appendCramer(NumberTable<EdgeTestSetUpState> &table)
{
    const auto append = [&table](QChar axis, QChar vertex, Quantity EdgeTestSetUpState::*member) {
        const QString name = u"%1_%2C"_s.arg(axis).arg(vertex);
        table.push_back({plainNumber(name, name, "px", u"%1 of %2 − C."_s.arg(axis).arg(vertex),
                                     u"%1 = %2_%3 − %2_C"_s.arg(name).arg(axis).arg(vertex)),
                         std::mem_fn(member)});
    };
    append(u'x', u'A', &EdgeTestSetUpState::xAC);
    append(u'y', u'A', &EdgeTestSetUpState::yAC);
    append(u'x', u'B', &EdgeTestSetUpState::xBC);
    append(u'y', u'B', &EdgeTestSetUpState::yBC);
    table.push_back({comparedNumber("D", "D", "px²", "The determinant |A − C, B − C|.",
                                    "D = x_AC·y_BC − x_BC·y_AC"),
                     std::mem_fn(&EdgeTestSetUpState::determinant)});
}

/// The increments of the weights and levels.
void appendRates(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names)
{
    for (const char16_t axis : {u'x', u'y'}) {
        const QChar coefficient = axis == u'x' ? u'a' : u'b';
        const auto rates
            = axis == u'x' ? &EdgeTestSetUpState::weightPerX : &EdgeTestSetUpState::weightPerY;
        for (std::size_t line = 0; line < 3; ++line) {
            table.push_back(
                {comparedNumber(
                     names.filledId("delta_{w}_", line) + QChar(axis),
                     names.filled("Δ{w}_", line) + QChar(axis), {},
                     names.filled("Change of the weight of vertex {facing} for each step of ", line)
                         + QChar(axis) + u'.',
                     names.filled(u"Δ{w}_%1 = %2{l}/f{opp}"_s.arg(QChar(axis)).arg(coefficient),
                                  line)),
                 [line, rates](const EdgeTestSetUpState &state) { return (state.*rates)[line]; }});
        }
    }
    for (const QChar axis : {u'x', u'y'}) {
        const auto rates
            = axis == u'x' ? &EdgeTestSetUpState::colourPerX : &EdgeTestSetUpState::colourPerY;
        appendChannels(
            table,
            comparedNumber(u"delta_%_"_s + axis, u"Δ%_"_s + axis, "levels/px",
                           u"Change of % for each step of "_s + axis + u'.',
                           u"Δ%_{} = Δα_{}·%_a + Δβ_{}·%_b + Δγ_{}·%_c"_s.replace(u"{}"_s, axis)),
            [rates](const EdgeTestSetUpState &state, std::size_t channel) {
                return (state.*rates)[channel];
            });
    }
}

} // namespace

NumberTable<EdgeTestSetUpState> edgeTestSetUpNumbers(const EdgeTestForm &form)
{
    const EdgeTestNames names(form);
    NumberTable<EdgeTestSetUpState> table;
    appendVertices(table, names);
    appendBox(table, names);
    if (form.inside == InsideTest::Cramer)
        appendCramer(table);
    for (std::size_t line = 0; line < 3 && form.inside != InsideTest::Cramer; ++line)
        appendLine(table, names, line);
    appendTies(table, names);
    if (form.isBarycentric() && form.evaluation == Evaluation::Increments)
        appendRates(table, names);
    appendColours(table, names);
    return table;
}

} // namespace pixelplumb
