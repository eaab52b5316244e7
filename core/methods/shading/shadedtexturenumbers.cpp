// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/methods/words/placenumbers.h"

#include <array>
#include <cmath>
#include <optional>

namespace pixelplumb {

namespace {

/// Where a sample lies along a side of the texture, in texels from the first one's edge, or from
/// its centre where four are read: "32·u − ½".
QString placeText(const ShadedSampleState &state, std::size_t side)
{
    return u"%1·%2%3"_s.arg(state.textureSize[side])
        .arg(QChar(side == 0 ? u'u' : u'v'))
        .arg(state.isFiltered ? u" − ½"_s : QString());
}

/// That place as a number; none if nothing is read, or beyond ±2^30, where a float kernel gives up
/// and takes texel 0.
std::optional<double> placeOf(const ShadedSampleState &state, std::size_t side)
{
    const Quantity &value = state.interpolatedIn(indexOf(Channel::U) + side);
    if (!state.isWritten || !state.effects.texture || value.isNone())
        return std::nullopt;
    const double place
        = value.toDouble() * state.textureSize[side] - (state.isFiltered ? 0.5 : 0.0);
    return std::abs(place) < double(1 << 29) ? std::optional(place) : std::nullopt;
}

bool liesInside(double place, std::int32_t size) { return place >= 0 && place < size; }

/// "i = ⌊32·u⌋", and how an index outside the texture is brought back.
QString indexFormula(const ShadedSampleState &state, std::size_t side, const QString &index)
{
    const std::optional<double> place = placeOf(state, side);
    if (!place)
        return {};
    const std::int32_t size = state.textureSize[side];
    const QString below = u'⌊' + placeText(state, side) + u'⌋';
    const QString left = index + u" = "_s;
    if (liesInside(*place, size))
        return left + below;
    return left
        + (state.wrap == TextureWrap::Clamp ? u"min(max(%1, 0), %2)"_s.arg(below).arg(size - 1)
                                            : u"%1 − %2·⌊%1/%2⌋"_s.arg(below).arg(size));
}

QString fractionFormula(const ShadedSampleState &state, std::size_t side, const QString &fraction,
                        const QString &index)
{
    const std::optional<double> place = placeOf(state, side);
    if (!place)
        return {};
    const QString text = placeText(state, side);
    return u"%1 = %2 − %3"_s.arg(
        fraction, text, liesInside(*place, state.textureSize[side]) ? index : u'⌊' + text + u'⌋');
}

bool isFiltered(const ShadedSampleState &state)
{
    return state.isWritten && state.effects.texture && state.isFiltered;
}

void appendFourTexels(NumberTable<ShadedSampleState> &table)
{
    const std::array names = {"t00", "t10", "t01", "t11"};
    const std::array places = {"texel (i, j)", "the texel next to it along u",
                               "the texel next to it along v", "the texel next to it along both"};
    for (std::size_t k = 0; k < names.size(); ++k)
        appendBytes(table, names[k], u"% of %1, of the four that are mixed."_s.arg(places[k]), {},
                    [k](const ShadedSampleState &state) {
                        return isFiltered(state) ? std::optional(state.texels[k]) : std::nullopt;
                    });
}

} // namespace

void appendTexels(NumberTable<ShadedSampleState> &table, const ShadedScope &scope)
{
    for (std::size_t side = 0; side < 2; ++side) {
        const QString index = side == 0 ? u"i"_s : u"j"_s;
        const QString coordinate = side == 0 ? u"u"_s : u"v"_s;
        table.push_back(
            {plainNumber(index, index, {}, u"The texel's place along %1, from 0."_s.arg(coordinate),
                         {}, NumberGroup::FirstColour),
             ofWritten([side](const ShadedSampleState &state) {
                 return state.effects.texture ? Quantity::integer(state.firstTexel[side])
                                              : Quantity();
             }),
             [=](NumberDescription &number, const ShadedSampleState &state) {
                 number.formula = indexFormula(state, side, index);
             }});
        if (!scope.isFiltered)
            continue;
        const QString fraction = u"f_"_s + coordinate;
        table.push_back(
            {comparedNumber(
                 fraction, fraction, {},
                 u"How far the sample lies between the centres of two texels along %1: 0 at the "
                 "first one's. Beyond the texture they are those that would stand there."_s.arg(
                     coordinate),
                 {}, NumberGroup::FirstColour),
             ofWritten([side](const ShadedSampleState &state) {
                 return isFiltered(state) ? state.fraction[side] : Quantity();
             }),
             [=](NumberDescription &number, const ShadedSampleState &state) {
                 if (isFiltered(state))
                     number.formula = fractionFormula(state, side, fraction, index);
             }});
    }
    if (scope.isFiltered)
        appendFourTexels(table);
    appendBytes(
        table, "t", "% of the texel, or of the four.", {},
        [](const ShadedSampleState &state) {
            return state.effects.texture ? std::optional(state.texel) : std::nullopt;
        },
        [](const ShadedSampleState &state) {
            return isFiltered(state)
                ? u"t_% = ⌊(t00_%·(1 − f_u) + t10_%·f_u)·(1 − f_v) + (t01_%·(1 − "
                  "f_u) + t11_%·f_u)·f_v + ½⌋"_s
                : QString();
        });
    appendBytes(
        table, "mod", "% modulated by the texel.", "mod_% = ⌊base_%·t_%/255 + ½⌋",
        [](const ShadedSampleState &state) { return state.textured; },
        [](const ShadedSampleState &state) {
            return state.effects.texture ? QString() : u"mod_% = base_%"_s;
        });
}

} // namespace pixelplumb
