// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/shadednumbers.h"

#include "core/methods/edgewalknames.h"
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"

#include <utility>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

void appendVertices(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope)
{
    const QString owner = isBilinear(scope.form) ? u"%1 of the sorted vertex P%2"_s
                                                 : u"%1 of P%2, as it is given"_s;
    const QString dash = scope.isPlanned ? QString() : u"_"_s;
    for (std::size_t digit = 0; digit < 3; ++digit) {
        const auto row = [&](const QString &name, const QString &unit, const QString &toolTip,
                             const auto &read) {
            table.push_back(
                {plainNumber(name + dash + QString::number(digit), name + vertexDigits[digit], unit,
                             owner.arg(name).arg(vertexDigits[digit]) + toolTip),
                 [=](const ShadedSetUpState &state) {
                     return read(state, state.vertexOf(digit));
                 }});
        };
        const QString fromCentre = ", from the centre of pixel (0, 0).";
        row("x", "px", fromCentre, [](const ShadedSetUpState &state, std::size_t vertex) {
            return pixels(state.position[vertex].x);
        });
        row("y", "px", fromCentre, [](const ShadedSetUpState &state, std::size_t vertex) {
            return pixels(state.position[vertex].y);
        });
        if (scope.effects.perspective)
            row("w", {}, ": what the camera divided by.",
                [](const ShadedSetUpState &state, std::size_t vertex) { return state.w[vertex]; });
    }
}

/// A channel at the vertices; where perspective is corrected, also divided by w.
void appendValues(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope,
                  const ScopedChannel &channel)
{
    const auto [at, which] = channel;
    const bool isDivided = scope.effects.perspective && which != Channel::Depth;
    for (std::size_t digit = 0; digit < 3; ++digit) {
        const QString given = shadedName(which);
        if (which != Channel::Reciprocal)
            table.push_back(
                {plainNumber(given + QString::number(digit), given + vertexDigits[digit],
                             unitOf(which), u"%1 at P%2."_s.arg(given).arg(vertexDigits[digit]), {},
                             Group::EdgeColours),
                 [digit, at = channel.at](const ShadedSetUpState &state) {
                     return state.given[at][state.vertexOf(digit)];
                 }});
        if (!isDivided)
            continue;
        const QString name = linearName(which, scope.effects);
        const QString above = which == Channel::Reciprocal ? u"1"_s : given + vertexDigits[digit];
        table.push_back(
            {comparedNumber(
                 name + QString::number(digit), name + vertexDigits[digit], unitOf(which),
                 (which == Channel::Reciprocal
                      ? u"%1 at P%2 divided by its w, or as it is where nothing "
                        "is divided: what is linear in the frame."_s
                      : u"%1 at P%2, divided by its w unless it is the same at all "
                        "vertices: what is linear in the frame."_s)
                     .arg(which == Channel::Reciprocal ? u"1"_s : given)
                     .arg(vertexDigits[digit]),
                 u"%1 = %2/w%3"_s.arg(name + vertexDigits[digit], above, vertexDigits[digit]),
                 Group::EdgeColours),
             [digit, at = channel.at](const ShadedSetUpState &state) {
                 return state.linear[at][state.vertexOf(digit)];
             },
             [=, at = channel.at](NumberDescription &number, const ShadedSetUpState &state) {
                 if (state.isDivided[at])
                     return;
                 const bool divides = state.isDivided[indexOf(Channel::Reciprocal)];
                 number.formula = u"%1 = %2"_s.arg(number.title, above);
                 number.toolTip
                     = (divides ? u"%1 itself: the vertices agree in it."_s
                                : u"%1 itself: there is nothing to correct in this triangle."_s)
                           .arg(above);
             }});
    }
}

/// The state's edge between the vertices that the digits of an edge name.
std::size_t edgeIn(const ShadedSetUpState &state, SortedEdge named)
{
    if (isBilinear(state.form))
        return std::size_t(named);
    const std::array digits
        = {std::size_t(state.order[0]), std::size_t(state.order[1]), std::size_t(state.order[2])};
    for (const SortedEdge edge : sortedEdges) {
        if (subscriptOf(edge, digits) == subscriptOf(named))
            return std::size_t(edge);
    }
    return std::size_t(named);
}

/// "(% − %)/(x₁ − x₀)" of an edge; % stands for the letter.
QString slopeFormula(const EdgeWalkNames &names, const QString &title, SortedEdge edge,
                     const QString &letter)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    return title + u" = ("_s + letter + vertexDigits[ends[1]] + u" − "_s + letter
        + vertexDigits[ends[0]] + u")/"_s + names.way(ends[0], ends[1]);
}

/// What each span adds to its bound along an edge.
void appendSlope(NumberTable<ShadedSetUpState> &table, const EdgeWalkNames &names, SortedEdge edge)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const QString title = u'm' + subscriptOf(edge);
    table.push_back(
        {names.filled(comparedNumber(
             u"m_%1%2"_s.arg(ends[0]).arg(ends[1]), title, "px/{span}",
             u"Slope of the edge from P%1 to P%2: what each {span} "
             "adds to its {a}; none where it lies along the {span}s."_s.arg(vertexDigits[ends[0]])
                 .arg(vertexDigits[ends[1]]),
             slopeFormula(names, title, edge, "{a}"), Group::Position)),
         [=](const ShadedSetUpState &state) { return state.slope[edgeIn(state, edge)]; }});
}

/// What each span adds to a channel along an edge.
void appendRate(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope,
                const ScopedChannel &channel, SortedEdge edge)
{
    const EdgeWalkNames names = walkNames(scope.form);
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const QString name = linearName(channel.which, scope.effects);
    const QString title = u'δ' + name + subscriptOf(edge);
    table.push_back({names.filled(comparedNumber(
                         u"rate_%1_%2%3"_s.arg(name).arg(ends[0]).arg(ends[1]), title,
                         unitOf(channel.which, "/{span}"),
                         u"What each {span} adds to %1 along %2."_s.arg(name, nameOf(edge)),
                         slopeFormula(names, title, edge, name), Group::ColourRates)),
                     [edge, at = channel.at](const ShadedSetUpState &state) {
                         return state.rate[std::size_t(edge)][at];
                     },
                     ifCarried(scope, channel.at)});
}

} // namespace

NumberRow<ShadedSetUpState>::Specify ifCarried(const ShadedScope &scope, std::size_t at)
{
    if (scope.isPlanned)
        return {};
    return [at](NumberDescription &number, const ShadedSetUpState &state) {
        if (!state.carries(at))
            number.formula.clear();
    };
}

NumberTable<ShadedSetUpState> shadedSetUpNumbers(const ShadedScope &scope)
{
    NumberTable<ShadedSetUpState> table;
    appendVertices(table, scope);
    for (const ScopedChannel &channel : scope.channels)
        appendValues(table, scope, channel);
    for (const SortedEdge edge : sortedEdges) {
        if (scope.isPlanned || isBilinear(scope.form))
            appendSlope(table, walkNames(scope.form), edge);
    }
    for (const ScopedChannel &channel : scope.channels) {
        for (const SortedEdge edge : sortedEdges) {
            if (isBilinear(scope.form))
                appendRate(table, scope, channel, edge);
        }
    }
    appendPlanes(table, scope);
    if (scope.appearance)
        appendLightSources(table, scope.appearance);
    return table;
}

} // namespace pixelplumb
