// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shadednumbers.h"

#include <array>

namespace pixelplumb {

namespace {

/// Whether no texel that is read along a side is wrapped or clamped.
bool liesInside(const ShadedSampleState &state, std::size_t side)
{
    const Quantity &value = state.interpolatedIn(indexOf(Channel::U) + side);
    if (!state.isWritten || !state.effects.texture || value.isNone())
        return false;
    const double half = state.isFiltered ? 0.5 : 0;
    const double place = value.toDouble() * state.textureSize[side] - half;
    return place >= 0 && place < state.textureSize[side] - 2 * half;
}

bool isFiltered(const ShadedSampleState &state)
{
    return state.isWritten && state.effects.texture && state.isFiltered;
}

void appendFourTexels(NumberTable<ShadedSampleState> &table)
{
    const std::array names = {QStringLiteral("t00"), QStringLiteral("t10"), QStringLiteral("t01"),
                              QStringLiteral("t11")};
    const std::array places
        = {QStringLiteral("smaller i and smaller j"), QStringLiteral("larger i and smaller j"),
           QStringLiteral("smaller i and larger j"), QStringLiteral("larger i and larger j")};
    for (std::size_t k = 0; k < names.size(); ++k)
        appendBytes(table, names[k],
                    QStringLiteral("% of the one with %1 of the four texels.").arg(places[k]), {},
                    [k](const ShadedSampleState &state) {
                        return isFiltered(state) ? std::optional(state.texels[k]) : std::nullopt;
                    });
}

} // namespace

void appendTexels(NumberTable<ShadedSampleState> &table, const ShadedScope &scope)
{
    for (std::size_t side = 0; side < 2; ++side) {
        const QString index = side == 0 ? QStringLiteral("i") : QStringLiteral("j");
        const QString coordinate = side == 0 ? QStringLiteral("u") : QStringLiteral("v");
        table.push_back(
            {plainNumber(index, index, {},
                         QStringLiteral("The texel's place along %1, from 0.").arg(coordinate), {},
                         NumberGroup::FirstColour),
             ofWritten([side](const ShadedSampleState &state) {
                 return state.effects.texture ? Quantity::integer(state.firstTexel[side])
                                              : Quantity();
             }),
             [=](NumberDescription &number, const ShadedSampleState &state) {
                 if (!liesInside(state, side))
                     return;
                 const QString half = state.isFiltered ? QStringLiteral(" − ½") : QString();
                 number.formula = QStringLiteral("%1 = ⌊%2·%3%4⌋")
                                      .arg(index)
                                      .arg(state.textureSize[side])
                                      .arg(coordinate, half);
             }});
        if (!scope.isFiltered)
            continue;
        const QString fraction = QStringLiteral("f_") + coordinate;
        table.push_back(
            {plainNumber(fraction, fraction, {},
                         QStringLiteral("How far the sample lies from that texel's centre to the "
                                        "next one's, along %1.")
                             .arg(coordinate),
                         {}, NumberGroup::FirstColour),
             ofWritten([side](const ShadedSampleState &state) {
                 return isFiltered(state) ? state.fraction[side] : Quantity();
             }),
             [=](NumberDescription &number, const ShadedSampleState &state) {
                 if (isFiltered(state) && liesInside(state, side))
                     number.formula = QStringLiteral("%1 = %2·%3 − ½ − %4")
                                          .arg(fraction)
                                          .arg(state.textureSize[side])
                                          .arg(coordinate, index);
             }});
    }
    if (scope.isFiltered)
        appendFourTexels(table);
    appendBytes(
        table, QStringLiteral("t"), QStringLiteral("% of the texel, or of the four."), {},
        [](const ShadedSampleState &state) {
            return state.effects.texture ? std::optional(state.texel) : std::nullopt;
        },
        [](const ShadedSampleState &state) {
            return isFiltered(state) ? QStringLiteral(
                       "t_% = ⌊(t00_%·(1 − f_u) + t10_%·f_u)·(1 − f_v) + (t01_%·(1 − f_u) "
                       "+ t11_%·f_u)·f_v + ½⌋")
                                     : QString();
        });
    appendBytes(
        table, QStringLiteral("mod"), QStringLiteral("% modulated by the texel."),
        QStringLiteral("mod_% = ⌊base_%·t_%/255 + ½⌋"),
        [](const ShadedSampleState &state) { return state.textured; },
        [](const ShadedSampleState &state) {
            return state.effects.texture ? QString() : QStringLiteral("mod_% = base_%");
        });
}

} // namespace pixelplumb
