// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/outlinefillnumbers.h"

#include "core/methods/walks/outlinefillnames.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"

#include <QStringList>

#include <algorithm>
#include <functional>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// How the previous pixel led to the one that bounds the column; none at the edge's start.
void appendDecision(NumberTable<OutlineSpanState> &table, const QString &bound, const QString &word,
                    OutlineDecision OutlineSpanState::*decision,
                    OutlinePixel OutlineFillSpan<AnyArithmetic>::*pixel)
{
    const QString across = u"a_"_s + bound;
    const QString parameter = u"p_"_s + bound;
    const auto formula = [=](const QString &length, const QString &shorter) {
        return u"%1 = 2·%2·n_%3 − %4 − 2·%4·%5"_s.arg(parameter, shorter, bound, length, across);
    };
    table.push_back(
        {plainNumber(across, across, "px",
                     u"How far across the line had gone before the decision that led "
                     "to the pixel of the %1 y."_s.arg(word),
                     {}, Group::Decision),
         [decision](const OutlineSpanState &state) { return (state.*decision).across; }});
    table.push_back(
        {plainNumber(
             parameter, parameter, {},
             u"The decision parameter p_k that led to the pixel of the %1 y: below 0 the line "
             "stayed, else it went one across. None at the edge's first pixel."_s.arg(word),
             formula("Δ", "δ"), Group::Decision),
         [decision](const OutlineSpanState &state) { return (state.*decision).parameter; },
         [=](NumberDescription &number, const OutlineSpanState &state) {
             const std::size_t edge = (state.span.*pixel).edge;
             number.formula = formula(lengthTitle(edge), acrossTitle(edge));
         }});
}

/// Which pixel of which edge bounds the column.
void appendBound(NumberTable<OutlineSpanState> &table, const QString &bound, const QString &word,
                 OutlinePixel OutlineFillSpan<AnyArithmetic>::*pixel)
{
    const auto row = [&](const QString &letter, const QString &unit, const QString &toolTip,
                         const std::function<std::int64_t(const OutlinePixel &)> &read) {
        const QString title = letter + u'_' + bound;
        table.push_back({plainNumber(title, title, unit, toolTip, {}, Group::Span),
                         [=](const OutlineSpanState &state) {
                             return Quantity::integer(read(state.span.*pixel));
                         }});
    };
    row("y", "px", u"The outline's pixel of the %1 y in the column."_s.arg(word),
        [](const OutlinePixel &at) { return at.row; });
    row("edge", {}, u"Whose the pixel of the %1 y is: 0 is P₀P₁, 1 is P₁P₂, 2 is P₂P₀."_s.arg(word),
        [](const OutlinePixel &at) { return std::int64_t(at.edge); });
    row("n", {},
        u"How many steps of the midpoint algorithm it is from the edge's left end, "
        "or the one of smaller y where it is steep, to the pixel of the %1 y."_s.arg(word),
        [](const OutlinePixel &at) { return at.number; });
}

/// The line's colour at a bounding pixel.
void appendBoundColours(NumberTable<OutlineSpanState> &table, const QString &bound,
                        const QString &word, OutlinePixel OutlineFillSpan<AnyArithmetic>::*pixel,
                        std::array<Quantity, 3> ColumnState<AnyArithmetic>::*colour)
{
    const QString title = u"%_"_s + bound;
    appendChannels(
        table,
        comparedNumber(title, title, "levels",
                       u"Level of % at the outline's pixel of the %1 y, along its edge."_s.replace(
                           u"%1"_s, word),
                       title + u" = %_from + n·(%_to − %_from)/Δ"_s, Group::EdgeColours),
        [colour](const OutlineSpanState &state, std::size_t channel) {
            return (state.span.column.*colour)[channel];
        },
        [=](NumberDescription &number, const OutlineSpanState &state) {
            const OutlinePixel &at = state.span.*pixel;
            const OutlineEdge &edge = state.setUp.edges[at.edge];
            const QString from = QString(u'%') + vertexDigits[edge.ends[0]];
            const QString to = QString(u'%') + vertexDigits[edge.ends[1]];
            number.formula = title + u" = "_s + from;
            if (at.number > 0)
                number.formula += u" + n_"_s + bound + u"·("_s + to + u" − "_s + from + u")/"_s
                    + lengthTitle(at.edge);
        });
}

QString startFormula(const QString &title, bool hasRate)
{
    return hasRate ? title + u"%_low + (y_start − y_low)·Δ%"_s : title + u"%_low"_s;
}

void appendRamp(NumberTable<OutlineSpanState> &table)
{
    appendChannels(table,
                   comparedNumber("delta_%", "Δ%", "levels/row",
                                  "Change of % from row to row; none in a column of one pixel.",
                                  "Δ% = (%_high − %_low)/(y_high − y_low)", Group::ColourRates),
                   [](const OutlineSpanState &state, std::size_t channel) {
                       return state.hasRate() ? state.span.column.colourRate[channel] : Quantity();
                   });
    const QString title = "first % = ";
    appendChannels(
        table,
        comparedNumber("first_%", "first %", "levels",
                       "Level of % at y_start, the column's first drawn pixel.",
                       startFormula(title, true), Group::FirstColour),
        [](const OutlineSpanState &state, std::size_t channel) {
            return state.drawnSamples() > 0 ? state.span.column.firstColour[channel] : Quantity();
        },
        [title](NumberDescription &number, const OutlineSpanState &state) {
            number.formula = startFormula(title, state.hasRate());
        });
}

/// "row 5, pixel 3 of P₀P₁".
QString pixelText(const OutlinePixel &pixel)
{
    return u"row %1, pixel %2 of %3"_s.arg(pixel.row)
        .arg(pixel.number)
        .arg(outlineEdgeName(pixel.edge));
}

} // namespace

const NumberTable<OutlineSpanState> &outlineSpanNumbers()
{
    using State = OutlineSpanState;
    static const auto numbers = [] {
        using Span = OutlineFillSpan<AnyArithmetic>;
        using Column = ColumnState<AnyArithmetic>;
        const QString low = "low";
        const QString high = "high";
        NumberTable<State> table
            = {{triangleNumber(),
                [](const State &state) { return Quantity::integer(Int128(state.primitive)); }},
               {scannedNumber(),
                [](const State &state) { return Quantity::integer(state.span.column.x); }}};
        appendBound(table, low, "smallest", &Span::low);
        appendDecision(table, low, "smallest", &State::lowDecision, &Span::low);
        appendBound(table, high, "largest", &Span::high);
        appendDecision(table, high, "largest", &State::highDecision, &Span::high);
        table.push_back({columnPixelsNumber(), [](const State &state) {
                             return Quantity::integer(state.drawnSamples());
                         }});
        table.push_back(
            {plainNumber(
                 "first_drawn_row", "y_start", "px",
                 "The first drawn row, where the colours start: y_low, or the frame's first.", {},
                 Group::Span),
             [](const State &state) {
                 return state.drawnSamples() > 0 ? Quantity::integer(state.span.column.firstDrawn)
                                                 : Quantity();
             }});
        appendBoundColours(table, low, "smallest", &Span::low, &Column::colourBottom);
        appendBoundColours(table, high, "largest", &Span::high, &Column::colourTop);
        appendRamp(table);
        return table;
    }();
    return numbers;
}

const NumberTable<OutlineSampleState> &outlineSampleNumbers()
{
    using State = OutlineSampleState;
    static const auto numbers = [] {
        const QString title = u"% ← "_s;
        NumberTable<State> table;
        appendChannels(
            table,
            {.id = "%",
             .title = "%",
             .unit = "levels",
             .toolTip = "Level of % at the pixel.",
             .formula = "% ← %′ + Δ%",
             .startFormula = startFormula(title, true),
             .group = Group::FirstColour,
             .comparison = Comparison::WithExact},
            [](const State &state, std::size_t channel) { return state.colour[channel]; },
            [title](NumberDescription &number, const State &state) {
                if (state.isFirst)
                    number.formula = startFormula(title, state.hasRate);
                number.startFormula.clear();
            });
        return table;
    }();
    return numbers;
}

void tellOutline(StepWords &words, const OutlineFillSetUp &setUp)
{
    QStringList points;
    for (std::size_t corner = 0; corner < 3; ++corner)
        points.append(
            u"P%1 = %2"_s.arg(vertexDigits[corner]).arg(pointText(setUp.corners[corner].position)));
    words.sentence = u"On whole pixels: %1. The outline are the lines from one to "
                     "the next by the midpoint algorithm."_s.arg(points.join(u", "_s));
}

namespace {

/// " p_low = −3 < 0: at (4, 2) the line stayed." Empty for an edge's first pixel, which nothing
/// decides.
QString decidedSentence(const QString &bound, const OutlinePixel &pixel,
                        const OutlineDecision &decision, std::int64_t x)
{
    if (decision.parameter.isNone())
        return {};
    const bool stays = decision.parameter.numerator() < 0;
    return u" p_%1 = %2 %3 0: to (%4, %5) the line %6."_s.arg(
        bound, term(decision.parameter), stays ? u"<"_s : u"≥"_s, QString::number(x),
        QString::number(pixel.row), stays ? u"stayed"_s : u"went one across"_s);
}

} // namespace

void tellOutline(StepWords &words, const OutlineSpanState &state)
{
    words.heading = u"Column %1"_s.arg(state.span.column.x);
    words.sentence = state.hasRate()
        ? u"The outline reaches from %1, to %2: all between is filled."_s.arg(
            pixelText(state.span.low), pixelText(state.span.high))
        : u"The outline is one pixel high: %1."_s.arg(pixelText(state.span.low));
    const std::int64_t x = state.span.column.x;
    words.sentence += decidedSentence("low", state.span.low, state.lowDecision, x);
    if (state.hasRate())
        words.sentence += decidedSentence("high", state.span.high, state.highDecision, x);
    if (state.drawnSamples() == 0)
        words.sentence += u" The frame shows none of it."_s;
}

} // namespace pixelplumb
