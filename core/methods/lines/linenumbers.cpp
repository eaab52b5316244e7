// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines/linenumbers.h"

#include "core/methods/lines/lineendnumbers.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// The divisor of the increments in the current run.
void specifyDivisor(NumberDescription &number, const DdaSetUpState &setUp)
{
    if (setUp.isTooShort()) {
        number.formula.clear();
        return;
    }
    const QString steps = "(u₁ − u₀";
    number.formula.replace(steps, steps + divisorChange(setUp.variants));
}

/// Without a pre-step a line has its end's values at its first pixel.
void specifyStart(NumberDescription &number, const DdaState &step)
{
    if (step.isPoint)
        number.startFormula = number.startFormula.section(u" + "_s, 0, 0);
    else if (!step.hasPreStep)
        number.startFormula.replace(u"(u − u₀)"_s, u"(u − ⌈u₀⌉)"_s);
}

} // namespace

const NumberTable<SlopeInterceptSetUpState> &slopeInterceptSetUpNumbers()
{
    using State = SlopeInterceptSetUpState;
    static const auto numbers = [] {
        const QString left = u"of the left end, which is stored first."_s;
        const QString right = "of the right end.";
        NumberTable<State> table = {
            endNumber<State>(u'x', 0, left,
                             [](const State &setUp) { return pixels(setUp.start.position.x); }),
            endNumber<State>(u'y', 0, left,
                             [](const State &setUp) { return pixels(setUp.start.position.y); }),
            endNumber<State>(u'x', 1, right,
                             [](const State &setUp) { return pixels(setUp.end.position.x); }),
            endNumber<State>(u'y', 1, right,
                             [](const State &setUp) { return pixels(setUp.end.position.y); }),
            {comparedNumber("m", "m", "px/column", "The slope.", "m = (y₁ − y₀)/(x₁ − x₀)"),
             [](const State &setUp) { return setUp.slope; }},
            {comparedNumber("b", "b", "px", "Where the line meets the column 0.", "b = y₀ − m·x₀"),
             [](const State &setUp) { return setUp.intercept; }}};
        appendEndColours(table, 0, &State::start);
        appendEndColours(table, 1, &State::end);
        return table;
    }();
    return numbers;
}

const NumberTable<SlopeInterceptState> &slopeInterceptNumbers()
{
    static const auto numbers = [] {
        NumberTable<SlopeInterceptState> table = {
            {scannedNumber(),
             [](const SlopeInterceptState &step) { return Quantity::integer(step.place.along); }},
            {comparedNumber("y", "y", "px", "Where the line meets the column.", "y = m·x + b",
                            Group::Decision),
             [](const SlopeInterceptState &step) { return step.ordinate; }},
            {comparedNumber(
                 "y_r", "y_r", "px",
                 "The pixel's row: the cast to int drops the fraction, also of a negative number.",
                 "y_r = (int)(y + ½)", Group::Span),
             [](const SlopeInterceptState &step) { return Quantity::integer(step.place.across); }}};
        appendChannels(table,
                       comparedNumber("%", "%", "levels", "Level of % at this column.",
                                      "% = %₀ + (x − x₀)·((%₁ − %₀)/(x₁ − x₀))",
                                      Group::EdgeColours),
                       [](const SlopeInterceptState &step, std::size_t channel) {
                           return step.colour[channel];
                       });
        return table;
    }();
    return numbers;
}

const NumberTable<DdaSetUpState> &ddaSetUpNumbers()
{
    using State = DdaSetUpState;
    static const auto numbers = [] {
        const QString first = u"of the end that is stored first, the left one (of a "
                              "steep line the one of smaller y): "_s;
        const QString second = "of the other end: ";
        const QString along = "x; y where the line is steep.";
        const QString across = "y; x where the line is steep.";
        NumberTable<State> table
            = {endNumber<State>(u'u', 0, first + along,
                                [](const State &setUp) { return pixels(setUp.start.position.x); }),
               endNumber<State>(u'v', 0, first + across,
                                [](const State &setUp) { return pixels(setUp.start.position.y); }),
               endNumber<State>(u'u', 1, second + along,
                                [](const State &setUp) { return pixels(setUp.end.position.x); }),
               endNumber<State>(u'v', 1, second + across,
                                [](const State &setUp) { return pixels(setUp.end.position.y); }),
               {comparedNumber("m", "m", "px/step", "Δy/Δx; Δx/Δy where the line is steep.",
                               "m = (v₁ − v₀)/(u₁ − u₀)"),
                [](const State &setUp) { return setUp.isPoint() ? Quantity() : setUp.slope; },
                specifyDivisor}};
        appendEndColours(table, 0, &State::start);
        appendEndColours(table, 1, &State::end);
        appendChannels(
            table,
            comparedNumber("delta_%", "Δ%", "levels/step", "Change of % for each step.",
                           "Δ% = (%₁ − %₀)/(u₁ − u₀)", Group::ColourRates),
            [](const State &setUp, std::size_t channel) {
                return setUp.isPoint() ? Quantity() : setUp.colourRate[channel];
            },
            specifyDivisor);
        return table;
    }();
    return numbers;
}

const NumberTable<DdaState> &ddaNumbers()
{
    static const auto numbers = [] {
        NumberTable<DdaState> table = {
            {pixelX(), [](const DdaState &step) { return Quantity::integer(step.place.x()); }},
            {pixelY(), [](const DdaState &step) { return Quantity::integer(step.place.y()); }},
            {plainNumber("u", "u", "px", "Along the line: the column; the row where it is steep.",
                         {}, Group::Position),
             [](const DdaState &step) { return Quantity::integer(step.place.along); }},
            {{.id = "v",
              .title = "v",
              .unit = "px",
              .toolTip = "Across the line: y; x where it is steep.",
              .formula = "v ← v′ + m",
              .startFormula = "v = v₀ + (u − u₀)·m",
              .group = Group::Decision,
              .comparison = Comparison::WithExact},
             [](const DdaState &step) { return step.ordinate; },
             specifyStart},
            {comparedNumber("v_r", "v_r", "px",
                            "The pixel's place across the line, to the nearest; from the middle to "
                            "the larger one.",
                            "v_r = ⌊v + ½⌋", Group::Span),
             [](const DdaState &step) { return Quantity::integer(step.place.across); }}};
        appendChannels(
            table,
            {.id = "%",
             .title = "%",
             .unit = "levels",
             .toolTip = "Level of % at this step.",
             .formula = "% ← %′ + Δ%",
             .startFormula = "% = %₀ + (u − u₀)·Δ%",
             .group = Group::EdgeColours,
             .comparison = Comparison::WithExact},
            [](const DdaState &step, std::size_t channel) { return step.colour[channel]; },
            specifyStart);
        return table;
    }();
    return numbers;
}

} // namespace pixelplumb
