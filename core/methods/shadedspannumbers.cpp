// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/placenumbers.h"
#include "core/methods/shadednumbers.h"
#include "core/methods/units.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// The walk along the edges is described like the column scan's.
const EdgeWalkNames &walkNames()
{
    static const EdgeWalkNames names(
        EdgeWalkForm{SpanAxis::Column, WalkForm::Accumulated, ColourRate::Bilinear});
    return names;
}

/// A number walked along the edge that bounds a column: `value` is its letter at a vertex, `rate`
/// the letter of its change.
void appendWalked(NumberTable<ShadedSpanState> &table, SpanBound bound, NumberDescription number,
                  const QString &value, const QString &rate,
                  const std::function<Quantity(const ShadedSpanState &)> &read)
{
    number.formula = QStringLiteral("%1 ← %1′ + %2").arg(number.title, rate);
    table.push_back(
        {number, read, [=](NumberDescription &current, const ShadedSpanState &state) {
             const auto &corners = state.walk.corners;
             const bool isPoint
                 = !state.walk.start.hasPlane && corners[0].position == corners[2].position;
             // Exact numbers are the plane's, which in a point has P0's values.
             current.formula = isPoint && read(state).isRational()
                 ? QStringLiteral("%1 ← %2").arg(current.title,
                                                 value + vertexDigits[state.walk.digits[0]])
                 : walkNames().boundFormula(state.walk, bound, current.title, value, rate);
         }});
}

/// The values of an edge where it meets the column, and the change from row to row.
void appendBounds(NumberTable<ShadedSpanState> &table, const QString &name, const QString &unit,
                  std::size_t channel)
{
    const QString bottom = withSubscript(name, QStringLiteral("B"));
    const QString top = withSubscript(name, QStringLiteral("T"));
    const auto append = [&](SpanBound bound, const QString &title, const QString &edge,
                            PerChannel<Quantity> ShadedSpanState::*values) {
        appendWalked(
            table, bound,
            comparedNumber(title, title, unit,
                           QStringLiteral("%1 where the %2 edge meets the column; its rate is "
                                          "added from column to column.")
                               .arg(name, edge),
                           {}, Group::EdgeColours),
            name, u'δ' + name,
            [=](const ShadedSpanState &state) { return (state.*values)[channel]; });
    };
    append(SpanBound::Lower, bottom, QStringLiteral("smaller-y"), &ShadedSpanState::bottom);
    append(SpanBound::Upper, top, QStringLiteral("larger-y"), &ShadedSpanState::top);
    table.push_back(
        {comparedNumber(QStringLiteral("delta_") + name, u'Δ' + name,
                        unit.isEmpty() ? unit : unit + QStringLiteral("/row"),
                        QStringLiteral("Change of %1 from row to row, y growing.").arg(name),
                        QStringLiteral("Δ%1 = (%2 − %3)/(y_T − y_B)").arg(name, top, bottom),
                        Group::ColourRates),
         [=](const ShadedSpanState &state) { return state.rate[channel]; },
         [=](NumberDescription &number, const ShadedSpanState &state) {
             if (state.lower != state.upper)
                 return;
             const bool isPlanes = state.walk.start.hasPlane && state.rate[channel].isRational();
             number.formula = QStringLiteral("Δ%1 = ").arg(name)
                 + (isPlanes ? planeSlope(u'y').replace(u'%', name) : QStringLiteral("0"));
         }});
}

} // namespace

NumberTable<ShadedSpanState> shadedSpanNumbers(const ShadedScope &scope)
{
    NumberTable<ShadedSpanState> table;
    const auto whole = [&](const NumberDescription &number, const auto &read) {
        table.push_back({number, [read](const ShadedSpanState &state) {
                             return Quantity::integer(Int128(read(state)));
                         }});
    };
    const auto covered = [&](const NumberDescription &number, const auto &read) {
        table.push_back({number, [read](const ShadedSpanState &state) {
                             return state.isBounded ? Quantity::integer(read(state)) : Quantity();
                         }});
    };
    whole(triangleNumber(), [](const ShadedSpanState &state) { return state.walk.primitive; });
    whole(scannedNumber(), [](const ShadedSpanState &state) { return state.walk.column.x; });
    table.push_back({halfNumberOf(scope.form), [](const ShadedSpanState &state) {
                         return state.isBounded ? state.walk.halfNumber() : Quantity();
                     }});
    const auto bound = [&](SpanBound side, const QString &title, const QString &edge,
                           Quantity ShadedSpanState::*value) {
        appendWalked(table, side,
                     comparedNumber(title, title, unit::px(),
                                    QStringLiteral("Where the %1 edge meets the column.").arg(edge),
                                    {}, Group::Span),
                     QStringLiteral("y"), QStringLiteral("m"),
                     [value](const ShadedSpanState &state) { return state.*value; });
    };
    bound(SpanBound::Lower, QStringLiteral("y_B"), QStringLiteral("smaller-y"),
          &ShadedSpanState::lower);
    bound(SpanBound::Upper, QStringLiteral("y_T"), QStringLiteral("larger-y"),
          &ShadedSpanState::upper);
    covered({.id = QStringLiteral("first_row"),
             .title = QStringLiteral("y_first"),
             .unit = unit::px(),
             .toolTip = QStringLiteral("The first row whose centre is covered; with exact "
                                       "areas, the first of whose square the triangle has a part."),
             .formula = {},
             .group = Group::Span},
            [](const ShadedSpanState &state) { return state.firstRow; });
    covered({.id = QStringLiteral("last_row"),
             .title = QStringLiteral("y_last"),
             .unit = unit::px(),
             .toolTip = QStringLiteral("The last row whose centre is covered; with exact "
                                       "areas, the last of whose square the triangle has a part."),
             .formula = {},
             .group = Group::Span},
            [](const ShadedSpanState &state) { return state.endRow - 1; });
    NumberDescription count = columnPixelsNumber();
    count.toolTip = QStringLiteral("Rows from y_first to y_last inside the frame. Depth may refuse "
                                   "some, and samples beside the centres may lie on others: each "
                                   "pixel tells.");
    whole(count, [](const ShadedSpanState &state) { return state.drawnSamples(); });
    if (scope.form == InterpolationForm::Bilinear)
        forEachChannel(scope.effects, [&](std::size_t channel) {
            appendBounds(table, linearName(channelAt(channel), scope.effects),
                         unitOf(channelAt(channel)), channel);
        });
    return table;
}

} // namespace pixelplumb
