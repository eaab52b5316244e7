// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines/lineendnumbers.h"
#include "core/methods/lines/linenumbers.h"
#include "core/methods/words/placenumbers.h"

/// The numbers of lines led by the sign of a decision parameter.
namespace pixelplumb {

namespace {

using Group = NumberGroup;

NumberTable<DecisionSetUpState> decisionSetUpTable()
{
    using State = DecisionSetUpState;
    const QString first = "of the end that is stored first, the left one (of a steep line the one "
                          "of smaller y); x and y are exchanged where the line is steep.";
    const QString second = "of the other end; x and y are exchanged where the line is steep.";
    return {
        endNumber<State>(u'x', 0, first, [](const State &setUp) { return setUp.startX; }),
        endNumber<State>(u'y', 0, first, [](const State &setUp) { return setUp.startY; }),
        endNumber<State>(u'x', 1, second, [](const State &setUp) { return setUp.endX; }),
        endNumber<State>(u'y', 1, second, [](const State &setUp) { return setUp.endY; }),
        {plainNumber("delta_x", "Δx", "px",
                     "Length along the line, x and y exchanged where it is steep.", "Δx = x₁ − x₀"),
         [](const State &setUp) { return setUp.deltaX; }},
        {plainNumber("delta_y", "Δy", "px",
                     "Length across, without its sign, x and y exchanged where the line is steep.",
                     "Δy = max(y₁ − y₀, y₀ − y₁)"),
         [](const State &setUp) { return setUp.deltaY; }},
        {plainNumber("stay", "2Δy", {}, "Added to p where the line stays.", "2Δy = 2·Δy",
                     Group::Decision),
         [](const State &setUp) { return setUp.stayIncrement; }},
        {plainNumber("move", "2Δy − 2Δx", {}, "Added to p where the line goes one across.",
                     "2Δy − 2Δx = 2·Δy − 2·Δx", Group::Decision),
         [](const State &setUp) { return setUp.moveIncrement; }}};
}

/// Where the line is at the pixel of a decision, and its distances from the two pixels to choose
/// between.
void appendDistances(NumberTable<DecisionState> &table)
{
    using State = DecisionState;
    const auto specified = [](const QString &rising, const QString &falling) {
        return [=](NumberDescription &number, const State &step) {
            number.formula = step.falls() ? falling : rising;
        };
    };
    const auto row = [&](const QString &id, const QString &title, const QString &toolTip,
                         const QString &either, const QString &rising, const QString &falling,
                         const NumberRow<State>::Read &read) {
        table.push_back({comparedNumber(id, title, "px", toolTip, either, Group::Decision), read,
                         specified(rising, falling)});
    };
    table.push_back({plainNumber("x_k", "x_k", "px",
                                 "The column before this pixel's; the row before it where the line "
                                 "is steep. No pixel is before the first.",
                                 {}, Group::Decision),
                     [](const State &step) {
                         return step.startsLine ? Quantity()
                                                : Quantity::integer(step.place.along - 1);
                     }});
    table.push_back(
        {plainNumber("y_k", "y_k", "px",
                     "The row of the pixel before; its column where the line is steep. No pixel is "
                     "before the first: where p begins there, it is that one's own.",
                     {}, Group::Decision),
         [](const State &step) {
             return step.startsLine ? Quantity() : Quantity::integer(step.acrossBefore());
         }});
    row("y_line", "y_line",
        "y = m·(x_k + 1) + b, where the line is beside this pixel; x and y exchanged where it is "
        "steep.",
        "y_line = y₀ ± (x_k + 1 − x₀)·Δy/Δx", "y_line = y₀ + (x_k + 1 − x₀)·Δy/Δx",
        "y_line = y₀ − (x_k + 1 − x₀)·Δy/Δx", [](const State &step) { return step.ordinate; });
    row("d_lower", "d_lower",
        "How far the line is from the pixel that stays towards the one across, rising or falling; "
        "below 0 on its other side.",
        "d_lower = ±(y_line − y_k)", "d_lower = y_line − y_k", "d_lower = y_k − y_line",
        [](const State &step) { return step.distanceToLower(); });
    row("d_upper", "d_upper",
        "How far the line is from the pixel one across towards the one that stays, rising or "
        "falling; below 0 on its other side.",
        "d_upper = 1 ∓ (y_line − y_k)", "d_upper = y_k + 1 − y_line",
        "d_upper = y_line − (y_k − 1)", [](const State &step) { return step.distanceToUpper(); });
}

/// p for the pixel after the first one.
void specifyNextDecision(NumberDescription &number, const DecisionState &step)
{
    if (step.isLedByDecision())
        return;
    if (step.startsLine) {
        number.formula = "p_k₊₁ = 2Δy − Δx";
        return;
    }
    // Between whole pixels, what p stands for: Δx·(d_lower − d_upper) one step on.
    number.formula = step.falls() ? u"p_k₊₁ = Δx·(2·y_k − 2·(y₀ − (x_k + 2 − x₀)·Δy/Δx) − 1)"_s
                                  : u"p_k₊₁ = Δx·(2·(y₀ + (x_k + 2 − x₀)·Δy/Δx) − 2·y_k − 1)"_s;
}

} // namespace

const NumberTable<DecisionSetUpState> &bresenhamSetUpNumbers()
{
    static const auto numbers = [] {
        auto table = decisionSetUpTable();
        table.push_back({plainNumber("p_0", "p₀", {}, "The first decision parameter.",
                                     "p₀ = 2Δy − Δx", Group::Decision),
                         [](const DecisionSetUpState &setUp) { return setUp.firstDecision; }});
        const QString constant = "c = 2Δy %1 2·Δx·y₀ − 2Δy·x₀ − Δx";
        table.push_back({plainNumber("c", "c", {},
                                     "What of p_k = 2Δy·x_k ∓ 2Δx·y_k + c no pixel changes; the "
                                     "lower sign where the line falls.",
                                     constant.arg(QChar(u'±')), Group::Decision),
                         [](const DecisionSetUpState &setUp) { return setUp.constant; },
                         [constant](NumberDescription &number, const DecisionSetUpState &setUp) {
                             number.formula = constant.arg(QChar(setUp.falls ? u'−' : u'+'));
                         }});
        return table;
    }();
    return numbers;
}

const NumberTable<DecisionSetUpState> &symmetricSetUpNumbers()
{
    static const auto numbers = decisionSetUpTable();
    return numbers;
}

const NumberTable<DecisionState> &decisionNumbers()
{
    static const auto numbers = [] {
        NumberTable<DecisionState> table = {
            {plainNumber("k", "k", {}, "The decision's number; none at the first pixel."),
             [](const DecisionState &step) { return step.k; }},
            {{.id = "p_k",
              .title = "p_k",
              .toolTip = "The decision parameter, (d_lower − d_upper)·Δx: its sign tells which "
                         "pixel is nearer.",
              .formula = "p_k ← p_k₊₁′",
              .startFormula = "p_k = Δx·(d_lower − d_upper)",
              .group = Group::Decision},
             [](const DecisionState &step) { return step.decision; }},
            {pixelX(), [](const DecisionState &step) { return Quantity::integer(step.place.x()); }},
            {pixelY(), [](const DecisionState &step) { return Quantity::integer(step.place.y()); }},
            {plainNumber("increment", "Δp", {},
                         "2Δy where the line stays, 2Δy − 2Δx where it goes across.", {},
                         Group::Decision),
             [](const DecisionState &step) { return step.increment; },
             [](NumberDescription &description, const DecisionState &step) {
                 if (!step.isLedByDecision())
                     return;
                 description.formula = step.movesAcross ? u"Δp = 2Δy − 2Δx"_s : u"Δp = 2Δy"_s;
             }},
            {plainNumber("p_next", "p_k₊₁", {}, "The decision parameter for the next pixel.",
                         "p_k₊₁ = p_k + Δp", Group::Decision),
             [](const DecisionState &step) { return step.nextDecision; }, specifyNextDecision}};
        appendDistances(table);
        return table;
    }();
    return numbers;
}

} // namespace pixelplumb
