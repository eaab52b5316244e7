// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines/linenumbers.h"

#include "core/methods/lines/lineendnumbers.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"
#include "core/methods/words/units.h"

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
    const QString steps = QStringLiteral("(u₁ − u₀");
    number.formula.replace(steps, steps + divisorChange(setUp.variants));
}

/// Without a pre-step a line has its end's values at its first pixel.
void specifyStart(NumberDescription &number, const DdaState &step)
{
    if (step.isPoint)
        number.startFormula = number.startFormula.section(QStringLiteral(" + "), 0, 0);
    else if (!step.hasPreStep)
        number.startFormula.replace(QStringLiteral("(u − u₀)"), QStringLiteral("(u − ⌈u₀⌉)"));
}

} // namespace

const NumberTable<SlopeInterceptSetUpState> &slopeInterceptSetUpNumbers()
{
    using State = SlopeInterceptSetUpState;
    static const auto numbers = [] {
        const QString left = QStringLiteral("of the left end, which is stored first.");
        const QString right = QStringLiteral("of the right end.");
        NumberTable<State> table
            = {endNumber<State>(u'x', 0, left,
                                [](const State &setUp) { return pixels(setUp.start.position.x); }),
               endNumber<State>(u'y', 0, left,
                                [](const State &setUp) { return pixels(setUp.start.position.y); }),
               endNumber<State>(u'x', 1, right,
                                [](const State &setUp) { return pixels(setUp.end.position.x); }),
               endNumber<State>(u'y', 1, right,
                                [](const State &setUp) { return pixels(setUp.end.position.y); }),
               {{.id = QStringLiteral("m"),
                 .title = QStringLiteral("m"),
                 .unit = QStringLiteral("px/column"),
                 .toolTip = QStringLiteral("The slope."),
                 .formula = QStringLiteral("m = (y₁ − y₀)/(x₁ − x₀)"),
                 .comparison = Comparison::WithExact},
                [](const State &setUp) { return setUp.slope; }},
               {{.id = QStringLiteral("b"),
                 .title = QStringLiteral("b"),
                 .unit = unit::px(),
                 .toolTip = QStringLiteral("Where the line meets the column 0."),
                 .formula = QStringLiteral("b = y₀ − m·x₀"),
                 .comparison = Comparison::WithExact},
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
            {{.id = QStringLiteral("y"),
              .title = QStringLiteral("y"),
              .unit = unit::px(),
              .toolTip = QStringLiteral("Where the line meets the column."),
              .formula = QStringLiteral("y = m·x + b"),
              .group = Group::Decision,
              .comparison = Comparison::WithExact},
             [](const SlopeInterceptState &step) { return step.ordinate; }},
            {{.id = QStringLiteral("y_r"),
              .title = QStringLiteral("y_r"),
              .unit = unit::px(),
              .toolTip = QStringLiteral("The pixel's row: the cast to int drops the fraction, also "
                                        "of a negative number."),
              .formula = QStringLiteral("y_r = (int)(y + ½)"),
              .group = Group::Span,
              .comparison = Comparison::WithExact},
             [](const SlopeInterceptState &step) { return Quantity::integer(step.place.across); }}};
        appendChannels(table,
                       {.id = QStringLiteral("%"),
                        .title = QStringLiteral("%"),
                        .unit = unit::levels(),
                        .toolTip = QStringLiteral("Level of % at this column."),
                        .formula = QStringLiteral("% = %₀ + (x − x₀)·((%₁ − %₀)/(x₁ − x₀))"),
                        .group = Group::EdgeColours,
                        .comparison = Comparison::WithExact},
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
        const QString first = QStringLiteral("of the end that is stored first, the left one (of "
                                             "a steep line the one of smaller y): ");
        const QString second = QStringLiteral("of the other end: ");
        const QString along = QStringLiteral("x; y where the line is steep.");
        const QString across = QStringLiteral("y; x where the line is steep.");
        NumberTable<State> table
            = {endNumber<State>(u'u', 0, first + along,
                                [](const State &setUp) { return pixels(setUp.start.position.x); }),
               endNumber<State>(u'v', 0, first + across,
                                [](const State &setUp) { return pixels(setUp.start.position.y); }),
               endNumber<State>(u'u', 1, second + along,
                                [](const State &setUp) { return pixels(setUp.end.position.x); }),
               endNumber<State>(u'v', 1, second + across,
                                [](const State &setUp) { return pixels(setUp.end.position.y); }),
               {{.id = QStringLiteral("m"),
                 .title = QStringLiteral("m"),
                 .unit = QStringLiteral("px/step"),
                 .toolTip = QStringLiteral("Δy/Δx; Δx/Δy where the line is steep."),
                 .formula = QStringLiteral("m = (v₁ − v₀)/(u₁ − u₀)"),
                 .comparison = Comparison::WithExact},
                [](const State &setUp) { return setUp.isPoint() ? Quantity() : setUp.slope; },
                specifyDivisor}};
        appendEndColours(table, 0, &State::start);
        appendEndColours(table, 1, &State::end);
        appendChannels(
            table,
            {.id = QStringLiteral("delta_%"),
             .title = QStringLiteral("Δ%"),
             .unit = QStringLiteral("levels/step"),
             .toolTip = QStringLiteral("Change of % for each step."),
             .formula = QStringLiteral("Δ% = (%₁ − %₀)/(u₁ − u₀)"),
             .group = Group::ColourRates,
             .comparison = Comparison::WithExact},
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
            {{.id = QStringLiteral("u"),
              .title = QStringLiteral("u"),
              .unit = unit::px(),
              .toolTip = QStringLiteral("Along the line: the column; the row where it is steep."),
              .formula = {},
              .group = Group::Position},
             [](const DdaState &step) { return Quantity::integer(step.place.along); }},
            {{.id = QStringLiteral("v"),
              .title = QStringLiteral("v"),
              .unit = unit::px(),
              .toolTip = QStringLiteral("Across the line: y; x where it is steep."),
              .formula = QStringLiteral("v ← v′ + m"),
              .startFormula = QStringLiteral("v = v₀ + (u − u₀)·m"),
              .group = Group::Decision,
              .comparison = Comparison::WithExact},
             [](const DdaState &step) { return step.ordinate; },
             specifyStart},
            {{.id = QStringLiteral("v_r"),
              .title = QStringLiteral("v_r"),
              .unit = unit::px(),
              .toolTip
              = QStringLiteral("The pixel's place across the line, to the nearest; from the "
                               "middle to the larger one."),
              .formula = QStringLiteral("v_r = ⌊v + ½⌋"),
              .group = Group::Span,
              .comparison = Comparison::WithExact},
             [](const DdaState &step) { return Quantity::integer(step.place.across); }}};
        appendChannels(
            table,
            {.id = QStringLiteral("%"),
             .title = QStringLiteral("%"),
             .unit = unit::levels(),
             .toolTip = QStringLiteral("Level of % at this step."),
             .formula = QStringLiteral("% ← %′ + Δ%"),
             .startFormula = QStringLiteral("% = %₀ + (u − u₀)·Δ%"),
             .group = Group::EdgeColours,
             .comparison = Comparison::WithExact},
            [](const DdaState &step, std::size_t channel) { return step.colour[channel]; },
            specifyStart);
        return table;
    }();
    return numbers;
}

} // namespace pixelplumb
