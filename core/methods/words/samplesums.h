// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/placenumbers.h"
#include "core/shade/scratchframe.h"

#include <QStringList>

namespace pixelplumb {

/// Appends sum_R, sum_G, sum_B of a pixel's samples: "sum_R = 85 + 170 + 0 + 170". `samplesIn`
/// gives the samples of a state; none where its pixel has one.
template <class State, class Read>
void appendSampleSums(NumberTable<State> &table, const Read &samplesIn)
{
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const QString title = u"sum_"_s + channelLetters[channel];
        table.push_back(
            {plainNumber(title, title, {},
                         u"The sum of %1 over the pixel's samples, as they stand now."_s.arg(
                             channelLetters[channel]),
                         {}, NumberGroup::FirstColour),
             [=](const State &state) {
                 const auto colours = samplesIn(state).colours();
                 int sum = 0;
                 for (const QRgb colour : colours)
                     sum += unpacked(colour).channels[channel];
                 return colours.empty() ? Quantity() : Quantity::integer(sum);
             },
             [=](NumberDescription &number, const State &state) {
                 QStringList bytes;
                 for (const QRgb colour : samplesIn(state).colours())
                     bytes.append(QString::number(unpacked(colour).channels[channel]));
                 number.formula
                     = bytes.empty() ? QString() : title + u" = "_s + bytes.join(u" + "_s);
             }});
    }
}

} // namespace pixelplumb
