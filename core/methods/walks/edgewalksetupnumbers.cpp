// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"
#include "core/methods/walks/edgewalknumbers.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

namespace {

Quantity inPixels(Lattice units) { return Quantity::rational(units, unitsPerPixel); }

void appendCorner(NumberTable<EdgeWalkSetUpState> &table, std::size_t corner)
{
    const QString id = QString::number(corner);
    const QChar digit = vertexDigits[corner];
    const auto position = [&](QChar axis, Lattice LatticePoint::*coordinate) {
        table.push_back(
            {plainNumber(
                 axis + u"_"_s + id, QString(axis) + digit, "px",
                 u"%1 of the sorted vertex P%2, from the centre of pixel (0, 0)."_s.arg(axis).arg(
                     digit)),
             [=](const EdgeWalkSetUpState &state) {
                 return inPixels(state.walk.corners[corner].position.*coordinate);
             }});
    };
    position(u'x', &LatticePoint::x);
    position(u'y', &LatticePoint::y);
    appendChannels(table,
                   plainNumber(u"%_"_s + id, u'%' + QString(digit), "levels",
                               u"% of the sorted vertex P"_s + digit
                                   + u", with material and light where there are any."_s),
                   [corner](const EdgeWalkSetUpState &state, std::size_t channel) {
                       return Quantity::integer(
                           state.walk.corners[corner].colour.channels[channel]);
                   });
}

/// A triangle of zero area is coloured along L₀₂ alone.
bool isWalked(const EdgeWalkSetUpState &state, SortedEdge edge)
{
    return !state.walk.scan.zeroArea || edge == SortedEdge::L02;
}

/// The divisor of an increment along an edge in the current run.
void specifyDivisor(const EdgeWalkNames &names, SortedEdge edge, const EdgeWalkSetUpState &state,
                    NumberDescription &number)
{
    const VariantSet variants = state.walk.scan.zeroArea ? VariantSet{} : state.settings.variants;
    if (names.isTooShort(state.walk.corners, edge, variants)) {
        number.formula = number.title + u" = 0"_s;
        number.toolTip += names.filled(
            " Δ{c} − 1 leaves nothing to divide by: the edge stays at its first vertex.");
        return;
    }
    number.formula.replace(names.divisor(edge, {}), names.divisor(edge, variants));
}

/// Replaces @ and & in a text by the digits of the edge's ends.
QString betweenEnds(QString text, SortedEdge edge)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    return text.replace(u'@', vertexDigits[ends[0]]).replace(u'&', vertexDigits[ends[1]]);
}

void appendSlope(NumberTable<EdgeWalkSetUpState> &table, const EdgeWalkNames &names,
                 SortedEdge edge)
{
    const auto index = std::size_t(edge);
    const auto &ends = sortedEdgeEnds[index];
    const QString title = u'm' + subscriptOf(edge);
    table.push_back(
        {names.filled(comparedNumber(
             u"m_%1%2"_s.arg(ends[0]).arg(ends[1]), title, "px/{span}",
             u"Slope of %1: what each {span} adds to its {a}; none where "
             "it lies along the {span}s."_s.arg(nameOf(edge)),
             betweenEnds("%1 = ({a}& − {a}@)/%2", edge).arg(title, names.way(ends[0], ends[1])))),
         [=](const EdgeWalkSetUpState &state) {
             return isWalked(state, edge) && !names.hasNoSlope(state.walk.corners, edge)
                 ? state.walk.scan.slope[index]
                 : Quantity();
         },
         [=](NumberDescription &number, const EdgeWalkSetUpState &state) {
             specifyDivisor(names, edge, state, number);
         }});
}

void appendColourRates(NumberTable<EdgeWalkSetUpState> &table, const EdgeWalkNames &names,
                       SortedEdge edge)
{
    const auto index = std::size_t(edge);
    const auto &ends = sortedEdgeEnds[index];
    const QString title = u"δ%"_s + subscriptOf(edge);
    appendChannels(
        table,
        names.filled(comparedNumber(
            u"rate_%_%1%2"_s.arg(ends[0]).arg(ends[1]), title, "levels/{span}",
            u"What each {span} adds to % along "_s + nameOf(edge) + u'.',
            title + betweenEnds(" = (%& − %@)/", edge) + names.way(ends[0], ends[1]))),
        [=](const EdgeWalkSetUpState &state, std::size_t channel) {
            return isWalked(state, edge) && !names.hasNoSlope(state.walk.corners, edge)
                ? state.walk.scan.colourRate[index][channel]
                : Quantity();
        },
        [=](NumberDescription &number, const EdgeWalkSetUpState &state) {
            specifyDivisor(names, edge, state, number);
        });
}

} // namespace

NumberTable<EdgeWalkSetUpState> edgeWalkSetUpNumbers(const EdgeWalkForm &form)
{
    const EdgeWalkNames names(form);
    NumberTable<EdgeWalkSetUpState> table;
    for (std::size_t corner = 0; corner < 3; ++corner)
        appendCorner(table, corner);
    table.push_back({comparedNumber("A", "A", "px²",
                                    "Twice the area, positive where P₀ P₁ P₂ turn as from x to y.",
                                    u"A = "_s + doubledAreaText()),
                     [](const EdgeWalkSetUpState &state) {
                         const std::array<Vertex, 3> &corners = state.walk.corners;
                         return Quantity::rational(doubledArea(corners[0].position,
                                                               corners[1].position,
                                                               corners[2].position),
                                                   Int128(unitsPerPixel) * unitsPerPixel);
                     }});
    table.push_back(
        {names.filled(plainNumber("{a}_frame", "{a}_frame", "px", "The frame's first {across}.")),
         [](const EdgeWalkSetUpState &state) {
             return Quantity::integer(state.walk.firstOfFrame);
         }});
    for (const SortedEdge edge : {SortedEdge::L01, SortedEdge::L12, SortedEdge::L02})
        appendSlope(table, names, edge);
    for (const SortedEdge edge : {SortedEdge::L01, SortedEdge::L12, SortedEdge::L02})
        appendColourRates(table, names, edge);
    if (form.walk == WalkForm::Accumulated)
        return table;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const auto &ends = sortedEdgeEnds[edge];
        table.push_back({plainNumber(u"proved_%1%2"_s.arg(ends[0]).arg(ends[1]),
                                     u"proved"_s + subscriptOf(SortedEdge(edge)), {},
                                     u"1: L%1 lies within the proved domain and is computed in "
                                     "float64; 0: outside of it, in integers."_s.arg(
                                         subscriptOf(SortedEdge(edge)))),
                         [edge](const EdgeWalkSetUpState &state) {
                             return Quantity::integer(!state.walk.scan.slope[edge].isRational());
                         }});
    }
    return table;
}

} // namespace pixelplumb
