// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shadednumbers.h"

#include "core/methods/edgewalknames.h"
#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/units.h"

#include <utility>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// The vertex that a digit names: in the bilinear form vertices are sorted by x.
std::size_t vertexIn(const ShadedSetUpState &state, InterpolationForm form, std::size_t digit)
{
    return form == InterpolationForm::Bilinear ? std::size_t(state.order[digit]) : digit;
}

void appendVertices(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope)
{
    const InterpolationForm form = scope.form;
    const QString owner = form == InterpolationForm::Bilinear
        ? QStringLiteral("%1 of the sorted vertex P%2")
        : QStringLiteral("%1 of P%2, as it is given");
    for (std::size_t digit = 0; digit < 3; ++digit) {
        const auto row = [&](const QString &name, const QString &unit, const QString &toolTip,
                             const auto &read) {
            table.push_back({{.id = name + QString::number(digit),
                              .title = name + vertexDigits[digit],
                              .unit = unit,
                              .toolTip = owner.arg(name).arg(vertexDigits[digit]) + toolTip,
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
            table.push_back(
                {{.id = given + QString::number(digit),
                  .title = given + vertexDigits[digit],
                  .unit = unitOf(which),
                  .toolTip = QStringLiteral("%1 at P%2.").arg(given).arg(vertexDigits[digit]),
                  .formula = {},
                  .group = Group::EdgeColours},
                 [=](const ShadedSetUpState &state) {
                     return state.given[channel][vertexIn(state, form, digit)];
                 }});
        if (!isDivided)
            continue;
        const QString name = linearName(which, scope.effects);
        const QString above
            = which == Channel::Reciprocal ? QStringLiteral("1") : given + vertexDigits[digit];
        table.push_back(
            {comparedNumber(
                 name + QString::number(digit), name + vertexDigits[digit], unitOf(which),
                 QStringLiteral("%1 at P%2 divided by its w: what is linear in the frame.")
                     .arg(which == Channel::Reciprocal ? QStringLiteral("1") : given)
                     .arg(vertexDigits[digit]),
                 QStringLiteral("%1 = %2/w%3")
                     .arg(name + vertexDigits[digit], above, vertexDigits[digit]),
                 Group::EdgeColours),
             [=](const ShadedSetUpState &state) {
                 return state.linear[channel][vertexIn(state, form, digit)];
             },
             [=](NumberDescription &number, const ShadedSetUpState &state) {
                 if (state.isDivided[channel])
                     return;
                 const bool divides = state.isDivided[indexOf(Channel::Reciprocal)];
                 number.formula = QStringLiteral("%1 = %2").arg(number.title, above);
                 number.toolTip = (divides ? QStringLiteral("%1 itself: the vertices agree in it.")
                                           : QStringLiteral("%1 itself: there is nothing to "
                                                            "correct in this triangle."))
                                      .arg(above);
             }});
    }
}

/// The state's edge between the vertices that the digits of an edge name.
std::size_t edgeIn(const ShadedSetUpState &state, InterpolationForm form, SortedEdge named)
{
    if (form == InterpolationForm::Bilinear)
        return std::size_t(named);
    const std::array digits
        = {std::size_t(state.order[0]), std::size_t(state.order[1]), std::size_t(state.order[2])};
    for (const SortedEdge edge : sortedEdges) {
        if (subscriptOf(edge, digits) == subscriptOf(named))
            return std::size_t(edge);
    }
    return std::size_t(named);
}

/// "(% − %)/(x₁ − x₀)" of an edge; # and & are its ends, % the letter.
QString slopeFormula(const QString &title, SortedEdge edge, const QString &letter)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    return title
        + QString(QStringLiteral(" = (%& − %#)/(x& − x#)"))
              .replace(u'#', vertexDigits[ends[0]])
              .replace(u'&', vertexDigits[ends[1]])
              .replace(u'%', letter);
}

/// What each column adds to y along an edge.
void appendSlope(NumberTable<ShadedSetUpState> &table, InterpolationForm form, SortedEdge edge)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const QString title = u'm' + subscriptOf(edge);
    table.push_back(
        {comparedNumber(
             QStringLiteral("m_%1%2").arg(ends[0]).arg(ends[1]), title, QStringLiteral("px/column"),
             QStringLiteral("Slope of the edge from P%1 to P%2: what each column adds to its y; "
                            "none where it is vertical.")
                 .arg(vertexDigits[ends[0]])
                 .arg(vertexDigits[ends[1]]),
             slopeFormula(title, edge, QStringLiteral("y")), Group::Position),
         [=](const ShadedSetUpState &state) { return state.slope[edgeIn(state, form, edge)]; }});
}

/// What each column adds to a channel along an edge.
void appendRate(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope, std::size_t channel,
                SortedEdge edge)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const QString name = linearName(channelAt(channel), scope.effects);
    const QString title = u'δ' + name + subscriptOf(edge);
    table.push_back(
        {comparedNumber(
             QStringLiteral("rate_%1_%2%3").arg(name).arg(ends[0]).arg(ends[1]), title,
             isLevel(channelAt(channel)) ? QStringLiteral("levels/column") : QString(),
             QStringLiteral("What each column adds to %1 along %2.").arg(name, nameOf(edge)),
             slopeFormula(title, edge, name), Group::ColourRates),
         [=](const ShadedSetUpState &state) { return state.rate[std::size_t(edge)][channel]; }});
}

} // namespace

NumberTable<ShadedSetUpState> shadedSetUpNumbers(const ShadedScope &scope)
{
    NumberTable<ShadedSetUpState> table;
    appendVertices(table, scope);
    forEachChannel(scope.effects,
                   [&](std::size_t channel) { appendValues(table, scope, channel); });
    for (const SortedEdge edge : sortedEdges)
        appendSlope(table, scope.form, edge);
    if (scope.form == InterpolationForm::Bilinear)
        forEachChannel(scope.effects, [&](std::size_t channel) {
            for (const SortedEdge edge : sortedEdges)
                appendRate(table, scope, channel, edge);
        });
    appendPlanes(table, scope);
    if (scope.appearance)
        appendLightSources(table, scope.appearance);
    return table;
}

} // namespace pixelplumb
