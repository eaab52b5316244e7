// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shadednumbers.h"

#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/placenumbers.h"
#include "core/methods/units.h"

#include <utility>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

constexpr std::array<char16_t, 3> digits = {u'₀', u'₁', u'₂'};

QString unitOf(Channel channel) { return isLevel(channel) ? unit::levels() : QString(); }

/// The vertex that a digit names: of the bilinear form they are sorted by x.
std::size_t vertexIn(const ShadedSetUpState &state, InterpolationForm form, std::size_t digit)
{
    return form == InterpolationForm::Bilinear ? std::size_t(state.order[digit]) : digit;
}

void appendVertices(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope)
{
    const InterpolationForm form = scope.form;
    const QString owner = form == InterpolationForm::Bilinear
        ? QStringLiteral("%1 of the sorted vertex P%2")
        : QStringLiteral("%1 of vertex %2, as it is given");
    for (std::size_t digit = 0; digit < 3; ++digit) {
        const auto row = [&](const QString &name, const QString &unit, const QString &toolTip,
                             const auto &read) {
            table.push_back({{.id = name + QString::number(digit),
                              .title = name + digits[digit],
                              .unit = unit,
                              .toolTip = owner.arg(name).arg(digit) + toolTip,
                              .formula = {}},
                             [=](const ShadedSetUpState &state) {
                                 return read(state, vertexIn(state, form, digit));
                             }});
        };
        const QString fromCentre = QStringLiteral(", from the centre of pixel (0, 0).");
        row(QStringLiteral("x"), unit::px(), fromCentre,
            [](const ShadedSetUpState &state, std::size_t vertex) {
                return pixels(state.position[vertex].x);
            });
        row(QStringLiteral("y"), unit::px(), fromCentre,
            [](const ShadedSetUpState &state, std::size_t vertex) {
                return pixels(state.position[vertex].y);
            });
        if (scope.effects.perspective)
            row(QStringLiteral("w"), {}, QStringLiteral(": what the camera divided by."),
                [](const ShadedSetUpState &state, std::size_t vertex) { return state.w[vertex]; });
    }
}

/// A channel at the vertices; where perspective is corrected, also divided by w.
void appendValues(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope,
                  std::size_t channel)
{
    const InterpolationForm form = scope.form;
    const Channel which = channelAt(channel);
    const bool isDivided = scope.effects.perspective && which != Channel::Depth;
    for (std::size_t digit = 0; digit < 3; ++digit) {
        const QString given = shadedName(which);
        if (which != Channel::Reciprocal)
            table.push_back({{.id = given + QString::number(digit),
                              .title = given + digits[digit],
                              .unit = unitOf(which),
                              .toolTip = QStringLiteral("%1 at vertex %2.").arg(given).arg(digit),
                              .formula = {},
                              .group = Group::EdgeColours},
                             [=](const ShadedSetUpState &state) {
                                 return state.given[channel][vertexIn(state, form, digit)];
                             }});
        if (!isDivided)
            continue;
        const QString name = linearName(which, scope.effects);
        const QString above
            = which == Channel::Reciprocal ? QStringLiteral("1") : given + digits[digit];
        table.push_back(
            {comparedNumber(name + QString::number(digit), name + digits[digit], unitOf(which),
                            QStringLiteral("%1 at vertex %2 divided by its w: what is linear in "
                                           "the frame.")
                                .arg(which == Channel::Reciprocal ? QStringLiteral("1") : given)
                                .arg(digit),
                            QStringLiteral("%1 = %2/w%3")
                                .arg(name + digits[digit], above, QString(digits[digit])),
                            Group::EdgeColours),
             [=](const ShadedSetUpState &state) {
                 return state.linear[channel][vertexIn(state, form, digit)];
             }});
    }
}

void appendCoefficients(NumberTable<ShadedSetUpState> &table, const QString &name,
                        const QString &toolTip,
                        const std::function<Quantity(const ShadedSetUpState &, std::size_t)> &read)
{
    static const std::array letters
        = {QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")};
    for (std::size_t k = 0; k < letters.size(); ++k) {
        const QString title = coefficientOf(letters[k], name);
        table.push_back({comparedNumber(title, title, {}, toolTip, {}, Group::ColourRates),
                         [read, k](const ShadedSetUpState &state) { return read(state, k); }});
    }
}

/// What an edge has where it meets the column, and the change from row to row.
void appendBounds(NumberTable<ShadedSpanState> &table, const QString &name, const QString &unit,
                  std::size_t channel)
{
    const QString bottom = withSubscript(name, QStringLiteral("B"));
    const QString top = withSubscript(name, QStringLiteral("T"));
    const auto bound = [&](const QString &title, const QString &edge,
                           PerChannel<Quantity> ShadedSpanState::*values) {
        table.push_back(
            {comparedNumber(
                 title, title, unit,
                 QStringLiteral("%1 where the %2 edge meets the column.").arg(name, edge), {},
                 Group::EdgeColours),
             [=](const ShadedSpanState &state) { return (state.*values)[channel]; }});
    };
    bound(bottom, QStringLiteral("lower"), &ShadedSpanState::bottom);
    bound(top, QStringLiteral("upper"), &ShadedSpanState::top);
    table.push_back(
        {comparedNumber(QStringLiteral("delta_") + name, u'Δ' + name, unit,
                        QStringLiteral("Change of %1 for each upward move.").arg(name),
                        QStringLiteral("Δ%1 = (%2 − %3)/(y_T − y_B)").arg(name, top, bottom),
                        Group::ColourRates),
         [=](const ShadedSpanState &state) { return state.rate[channel]; },
         [](NumberDescription &number, const ShadedSpanState &state) {
             if (state.lower == state.upper)
                 number.formula.clear();
         }});
}

} // namespace

NumberTable<ShadedSetUpState> shadedSetUpNumbers(const ShadedScope &scope)
{
    NumberTable<ShadedSetUpState> table;
    appendVertices(table, scope);
    forEachChannel(scope.effects,
                   [&](std::size_t channel) { appendValues(table, scope, channel); });
    if (scope.form == InterpolationForm::Plane)
        forEachChannel(scope.effects, [&](std::size_t channel) {
            const QString name = linearName(channelAt(channel), scope.effects);
            appendCoefficients(table, name,
                               QStringLiteral("Of %1 = a·x + b·y + c over the triangle.").arg(name),
                               [channel](const ShadedSetUpState &state, std::size_t k) {
                                   return state.plane[channel][k];
                               });
        });
    if (scope.form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            appendCoefficients(
                table, weightTitle(i),
                QStringLiteral("Of the weight of vertex %1, a·x + b·y + c.").arg(i),
                [i](const ShadedSetUpState &state, std::size_t k) { return state.weight[i][k]; });
    }
    return table;
}

NumberTable<ShadedSpanState> shadedSpanNumbers(const ShadedScope &scope)
{
    using State = ShadedSpanState;
    NumberTable<State> table;
    const auto whole = [&](const NumberDescription &number, const auto &read) {
        table.push_back({number, [read](const State &state) {
                             return Quantity::integer(Int128(read(state)));
                         }});
    };
    whole(triangleNumber(), [](const State &state) { return state.primitive; });
    whole(scannedNumber(), [](const State &state) { return state.x; });
    whole(halfNumber(), [](const State &state) { return int(state.half) + 1; });
    const auto bound = [&](const QString &title, const QString &edge, Quantity State::*value) {
        table.push_back(
            {comparedNumber(title, title, unit::px(),
                            QStringLiteral("Where the %1 edge meets the column.").arg(edge), {},
                            Group::Span),
             [value](const State &state) { return state.*value; }});
    };
    bound(QStringLiteral("y_B"), QStringLiteral("lower"), &State::lower);
    bound(QStringLiteral("y_T"), QStringLiteral("upper"), &State::upper);
    whole({.id = QStringLiteral("first_row"),
           .title = QStringLiteral("y_first"),
           .unit = unit::px(),
           .toolTip = QStringLiteral("The first covered row."),
           .formula = {},
           .group = Group::Span},
          [](const State &state) { return state.firstRow; });
    whole({.id = QStringLiteral("last_row"),
           .title = QStringLiteral("y_last"),
           .unit = unit::px(),
           .toolTip = QStringLiteral("The last covered row."),
           .formula = {},
           .group = Group::Span},
          [](const State &state) { return state.endRow - 1; });
    whole(columnPixelsNumber(), [](const State &state) { return state.drawnSamples(); });
    if (scope.form == InterpolationForm::Bilinear)
        forEachChannel(scope.effects, [&](std::size_t channel) {
            appendBounds(table, linearName(channelAt(channel), scope.effects),
                         unitOf(channelAt(channel)), channel);
        });
    return table;
}

} // namespace pixelplumb
