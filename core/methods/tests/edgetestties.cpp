// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/edgetestnames.h"
#include "core/methods/tests/edgetestnumbers.h"
#include "core/methods/words/placenumbers.h"

#include <functional>

/// Who owns a sample exactly on an edge, and the numbers by which the fill rule decides it.
namespace pixelplumb {

namespace {

using State = EdgeTestSetUpState;

/// "f_bc(a)·f_bc(r)".
QString productTitle(const EdgeTestNames &names, std::size_t line)
{
    return names.filled("{value}({letter})·{value}(r)", line);
}

NumberRow<State> pointNumber(QChar axis, Quantity State::*coordinate)
{
    return {plainNumber(axis + u"_r"_s, axis + u"_r"_s, "px",
                        axis + u" of the off-screen point r, from the centre of pixel (0, 0)."_s),
            std::mem_fn(coordinate)};
}

/// How the off-screen-point rule finds on which side of an edge r lies.
void appendSides(NumberTable<State> &table, const EdgeTestNames &names, std::size_t line)
{
    const auto filled
        = [&](const char16_t *text) { return names.filled(QString::fromUtf16(text), line); };
    const QString square = names.form().line == LineForm::Solved ? QString() : "px²";
    const bool isCramer = names.form().inside == InsideTest::Cramer;
    const QString atFacing = names.form().isBarycentric() ? filled(u"f{opp}") : filled(u"F{l}");
    if (isCramer)
        table.push_back(
            {comparedNumber(
                 names.filledId("f{opp}", line), atFacing, square,
                 filled(u"The edge function of {edge} at vertex {facing}, which faces it."),
                 atFacing + u" = "_s + names.filled(names.valueAt(line, "x{opp}", "y{opp}"), line)),
             [line](const State &state) {
                 const EdgeTestLineState &of = state.lines[line];
                 return of.atRulesPoint.isNone() ? Quantity() : of.atOpposite;
             }});
    const QString atPoint = filled(u"{value}(r)");
    table.push_back(
        {comparedNumber(names.filledId("{value}_r", line), atPoint, square,
                        filled(u"The edge function of {edge} at the off-screen point r."),
                        atPoint + u" = "_s + names.filled(names.valueAt(line, "x_r", "y_r"), line)),
         [line](const State &state) { return state.lines[line].atRulesPoint; }});
    table.push_back(
        {comparedNumber(
             names.filledId("tie_product{l}", line), productTitle(names, line), {},
             filled(u"Above 0 where {facing} and r lie on the same side of edge {edge}: it "
                    u"owns a sample exactly on the edge."),
             productTitle(names, line) + u" = "_s + atFacing + u'·' + atPoint),
         [line](const State &state) { return state.lines[line].tieProduct; }});
}

/// What decides under a rule that displaces samples: the coefficient along the displacement, or the
/// one across it where the first is 0. Empty for Cramer's rule, which has none.
QString displacedCondition(const EdgeTestNames &names, std::size_t line, const State &state)
{
    const EdgeTestLineState &edge = state.lines[line];
    if (names.form().inside == InsideTest::Cramer || edge.atOpposite.toDouble() == 0)
        return {};
    const bool isTopLeft = state.rule == FillRule::TopLeft;
    const bool turns = (isTopLeft ? edge.a : edge.b).toDouble() == 0;
    const bool isByY = isTopLeft == turns;
    if ((isByY ? edge.b : edge.a).toDouble() == 0)
        return {};
    // The rule top-left goes down on the screen where an edge is level.
    const bool isNegative = isTopLeft && isByY && state.down < 0;
    const QString coefficient = isByY ? u"b{l}"_s : u"a{l}"_s;
    return names.filled(names.towardsFacing(coefficient), line)
        + (isNegative ? u" < 0"_s : u" > 0"_s);
}

QString condition(const EdgeTestNames &names, std::size_t line, const State &state)
{
    switch (state.rule) {
    case FillRule::OffScreenPoint:
        return productTitle(names, line) + u" > 0"_s;
    case FillRule::HalfOpenColumn:
    case FillRule::TopLeft:
        return displacedCondition(names, line, state);
    case FillRule::Closed:
    case FillRule::Open:
        break;
    }
    return {};
}

} // namespace

void appendTies(NumberTable<State> &table, const EdgeTestNames &names)
{
    table.push_back(pointNumber(u'x', &State::rulesX));
    table.push_back(pointNumber(u'y', &State::rulesY));
    for (std::size_t line = 0; line < 3; ++line)
        appendSides(table, names, line);
    for (std::size_t line = 0; line < 3; ++line)
        table.push_back(
            {plainNumber(
                 names.filledId("tie{l}", line), names.filled("tie{l}", line), {},
                 names.filled("1: under the fill rule, a sample exactly on edge {edge} is inside.",
                              line)),
             [line](const State &state) { return Quantity::integer(state.ownsTie[line]); },
             [names, line](NumberDescription &number, const State &state) {
                 const QString decides = state.zeroArea ? QString() : condition(names, line, state);
                 if (!decides.isEmpty())
                     number.formula = u"%1 = 1 if %2, else 0"_s.arg(number.title, decides);
             }});
}

} // namespace pixelplumb
