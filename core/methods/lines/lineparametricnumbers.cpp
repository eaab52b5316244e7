// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines/lineendnumbers.h"
#include "core/methods/lines/linenumbers.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"

/// The numbers of a line in its parametric form.
namespace pixelplumb {

namespace {

/// u or v: the point's x or y, and the pixel's.
void appendCoordinate(NumberTable<ParametricLineState> &table, QChar point, QChar axis,
                      Quantity ParametricLineState::*value,
                      std::int64_t (LinePlace::*pixel)() const)
{
    table.push_back({comparedNumber(point, point, "px", u"The point's %1."_s.arg(axis),
                                    u"%1 = %2₀ + k·i·((%2₁ − %2₀)/N)"_s.arg(point, axis),
                                    NumberGroup::Decision),
                     [value](const ParametricLineState &step) { return step.*value; }});
    table.push_back({comparedNumber(axis, axis, "px", u"The nearest pixel's %1."_s.arg(axis),
                                    u"%1 = ⌊%2 + ½⌋"_s.arg(axis, point), NumberGroup::Span),
                     [pixel](const ParametricLineState &step) {
                         return Quantity::integer((step.place.*pixel)());
                     }});
}

} // namespace

const NumberTable<ParametricLineSetUpState> &parametricLineSetUpNumbers()
{
    using State = ParametricLineSetUpState;
    static const auto numbers = [] {
        const QString first = u"of P₀, the end that is given first."_s;
        const QString second = "of P₁.";
        NumberTable<State> table = {
            endNumber<State>(u'x', 0, first,
                             [](const State &setUp) { return pixels(setUp.start.position.x); }),
            endNumber<State>(u'y', 0, first,
                             [](const State &setUp) { return pixels(setUp.start.position.y); }),
            endNumber<State>(u'x', 1, second,
                             [](const State &setUp) { return pixels(setUp.end.position.x); }),
            endNumber<State>(u'y', 1, second,
                             [](const State &setUp) { return pixels(setUp.end.position.y); }),
            {plainNumber("N", "N", {},
                         "The steps of t from 0 to 1: the pixels of the longer side, rounded up."),
             [](const State &setUp) { return Quantity::integer(setUp.steps); }},
            {plainNumber(
                 "k", "k", {},
                 "P(kt): how many times as fast as P(t) the line is run through, 1, 2 or 5."),
             [](const State &setUp) { return Quantity::integer(setUp.pace); }}};
        appendEndColours(table, 0, &State::start);
        appendEndColours(table, 1, &State::end);
        return table;
    }();
    return numbers;
}

const NumberTable<ParametricLineState> &parametricLineNumbers()
{
    using State = ParametricLineState;
    static const auto numbers = [] {
        NumberTable<State> table
            = {{plainNumber("i", "i", {}, "The step's number, from 0 at t = 0."),
                [](const State &step) { return Quantity::integer(step.number); }},
               {comparedNumber("t", "t", {}, "The parameter.", "t = i/N", NumberGroup::Decision),
                [](const State &step) { return step.t; }}};
        appendCoordinate(table, u'u', u'x', &State::x, &LinePlace::x);
        appendCoordinate(table, u'v', u'y', &State::y, &LinePlace::y);
        appendChannels(table,
                       comparedNumber("%", "%", "levels", "Level of % at the point.",
                                      "% = %₀ + k·i·((%₁ − %₀)/N)", NumberGroup::EdgeColours),
                       [](const State &step, std::size_t channel) { return step.colour[channel]; });
        return table;
    }();
    return numbers;
}

} // namespace pixelplumb
