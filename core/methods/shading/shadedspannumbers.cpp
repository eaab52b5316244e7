// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// A number walked along the edge that bounds a span: `value` is its letter at a vertex, `rate` the
/// letter of its change.
void appendWalked(NumberTable<ShadedSpanState> &table, const ShadedScope &scope, SpanBound bound,
                  NumberDescription number, const QString &value, const QString &rate,
                  const std::function<Quantity(const ShadedSpanState &)> &read)
{
    const EdgeWalkNames names = walkNames(scope.form);
    number = names.filled(number);
    number.formula = u"%1 ← %1′ + %2"_s.arg(number.title, rate);
    table.push_back({number, read,
                     [=, isPlanned = scope.isPlanned](NumberDescription &current,
                                                      const ShadedSpanState &state) {
                         const auto &corners = state.walk.corners;
                         const bool isPoint = isPlanned && !state.walk.start.hasPlane
                             && corners[0].position == corners[2].position;
                         // Exact numbers are the plane's, which in a point has P0's values.
                         current.formula = isPoint && read(state).isRational()
                             ? u"%1 ← %2"_s.arg(current.title,
                                                value + vertexDigits[state.walk.digits[0]])
                             : names.boundFormula(state.walk, bound, current.title, value, rate);
                     }});
}

/// Where the edges meet the span.
void appendBounds(NumberTable<ShadedSpanState> &table, const ShadedScope &scope)
{
    const auto bound = [&](SpanBound side, const QString &title, const QString &edge,
                           Quantity ShadedSpanState::*value) {
        appendWalked(table, scope, side,
                     comparedNumber(title, title, "px",
                                    u"Where the %1 edge meets the {span}."_s.arg(edge), {},
                                    Group::Span),
                     walkNames(scope.form).filled("{a}"), "m",
                     [value](const ShadedSpanState &state) { return state.*value; });
    };
    bound(SpanBound::Lower, "{a}_{lo}", "{lower}", &ShadedSpanState::lower);
    bound(SpanBound::Upper, "{a}_{hi}", "{upper}", &ShadedSpanState::upper);
}

/// A channel where an edge meets the span.
void appendBoundValue(NumberTable<ShadedSpanState> &table, const ShadedScope &scope,
                      const ScopedChannel &channel, SpanBound bound)
{
    const QString name = linearName(channel.which, scope.effects);
    const bool isLower = bound == SpanBound::Lower;
    const QString title = withSubscript(name, isLower ? u"{lo}"_s : u"{hi}"_s);
    appendWalked(
        table, scope, bound,
        comparedNumber(
            title, title, unitOf(channel.which),
            u"%1 where the %2 edge meets the {span}; its rate is added from {span} to {span}."_s
                .arg(name, isLower ? u"{lower}"_s : u"{upper}"_s),
            {}, Group::EdgeColours),
        name, u'δ' + name, [isLower, at = channel.at](const ShadedSpanState &state) {
            return (isLower ? state.bottom : state.top)[at];
        });
}

/// The change along the span.
void appendRate(NumberTable<ShadedSpanState> &table, const ShadedScope &scope,
                const ScopedChannel &channel)
{
    const QString name = linearName(channel.which, scope.effects);
    QString toolTip = u"Change of %1 from {across} to {across}, {a} growing"_s.arg(name);
    if (!scope.isPlanned)
        toolTip += u"; none where {a}_{lo} = {a}_{hi}, with nothing to share out"_s;
    table.push_back(
        {walkNames(scope.form)
             .filled(
                 comparedNumber(u"delta_"_s + name, u'Δ' + name, unitOf(channel.which, "/{across}"),
                                toolTip + u'.',
                                u"Δ%1 = (%2 − %3)/({a}_{hi} − {a}_{lo})"_s.arg(
                                    name, withSubscript(name, "{hi}"), withSubscript(name, "{lo}")),
                                Group::ColourRates)),
         [at = channel.at](const ShadedSpanState &state) { return state.rate[at]; },
         [=, at = channel.at, isPlanned = scope.isPlanned](NumberDescription &number,
                                                           const ShadedSpanState &state) {
             if (!isPlanned || state.lower != state.upper)
                 return;
             const bool isPlanes = state.walk.start.hasPlane && state.rate[at].isRational();
             number.formula = u"Δ%1 = "_s.arg(name)
                 + (isPlanes ? planeSlope(u'y').replace(u'%', name) : u"0"_s);
         }});
}

/// Which rows or columns the span covers.
void appendCovered(NumberTable<ShadedSpanState> &table, const ShadedScope &scope)
{
    const EdgeWalkNames names = walkNames(scope.form);
    const auto covered = [&](const QString &which, const auto &read) {
        const QString toolTip = scope.isPlanned
            ? u"The %1 row whose centre is covered; with exact areas, the %1 of "
              "whose square the triangle has a part."_s
            : u"The %1 covered {across}; exact in every arithmetic."_s;
        table.push_back({names.filled(plainNumber(which + u"_{across}"_s, u"{a}_"_s + which, "px",
                                                  toolTip.arg(which), {}, Group::Span)),
                         [read](const ShadedSpanState &state) {
                             return state.isBounded ? Quantity::integer(read(state)) : Quantity();
                         }});
    };
    covered("first", [](const ShadedSpanState &state) { return state.firstRow; });
    covered("last", [](const ShadedSpanState &state) { return state.endRow - 1; });
    NumberDescription count = columnPixelsNumber();
    count.toolTip = scope.isPlanned
        ? u"Rows from y_first to y_last inside the frame. Depth may refuse some, and "
          "samples beside the centres may lie on others: each pixel tells."_s
        : count.toolTip.replace(u"column"_s, u"{span}"_s);
    table.push_back({names.filled(count), [](const ShadedSpanState &state) {
                         return Quantity::integer(state.drawnSamples());
                     }});
}

} // namespace

NumberTable<ShadedSpanState> shadedSpanNumbers(const ShadedScope &scope)
{
    const EdgeWalkNames names = walkNames(scope.form);
    NumberTable<ShadedSpanState> table;
    table.push_back({triangleNumber(), [](const ShadedSpanState &state) {
                         return Quantity::integer(Int128(state.walk.primitive));
                     }});
    NumberDescription scanned = scannedNumber();
    scanned.id = scanned.title = "{c}";
    scanned.toolTip = "The {span}.";
    table.push_back({names.filled(scanned), [isRow = names.isRow()](const ShadedSpanState &state) {
                         return Quantity::integer(isRow ? -state.walk.column.x
                                                        : state.walk.column.x);
                     }});
    NumberDescription half = halfNumberOf(scope.form);
    half.id = half.title = "{half}";
    table.push_back({names.filled(half), [](const ShadedSpanState &state) {
                         return state.isBounded ? state.walk.halfNumber() : Quantity();
                     }});
    // With effects the bounds come first, and the numbers of a channel stand together.
    if (scope.isPlanned)
        appendBounds(table, scope);
    appendCovered(table, scope);
    if (!isBilinear(scope.form))
        return table;
    if (scope.isPlanned) {
        for (const ScopedChannel &channel : scope.channels) {
            appendBoundValue(table, scope, channel, SpanBound::Lower);
            appendBoundValue(table, scope, channel, SpanBound::Upper);
            appendRate(table, scope, channel);
        }
        return table;
    }
    appendBounds(table, scope);
    for (const SpanBound bound : {SpanBound::Lower, SpanBound::Upper}) {
        for (const ScopedChannel &channel : scope.channels)
            appendBoundValue(table, scope, channel, bound);
    }
    for (const ScopedChannel &channel : scope.channels)
        appendRate(table, scope, channel);
    return table;
}

} // namespace pixelplumb
