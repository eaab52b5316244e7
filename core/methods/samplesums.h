// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/scratchframe.h"
#include "core/methods/channelnumbers.h"

#include <QStringList>

namespace pixelplumb {

/// "sum_R = 85 + 170 + 0 + 170": the bytes of a channel in the pixel's samples, in their order.
inline QString sumFormula(const QString &title, const SampleMean &mean, std::size_t channel)
{
    QStringList bytes;
    for (const QRgb sample : mean.samples())
        bytes.append(QString::number(unpacked(sample).channels[channel]));
    return title + QStringLiteral(" = ") + bytes.join(QStringLiteral(" + "));
}

/// Appends sum_R, sum_G, sum_B of a pixel that is the mean of its samples; `meanIn` gives that
/// mean, without samples if the pixel is not one.
template <class State, class Read>
void appendSampleSums(NumberTable<State> &table, const Read &meanIn)
{
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const QString letter = QChar(channelLetters[channel]);
        const QString title = QStringLiteral("sum_") + letter;
        table.push_back(
            {{.id = title,
              .title = title,
              .unit = {},
              .toolTip
              = QStringLiteral("The sum of %1 over the pixel's samples, as they stand now.")
                    .arg(letter),
              .formula = {},
              .group = NumberGroup::FirstColour},
             [=](const State &state) {
                 const SampleMean &mean = meanIn(state);
                 return mean.samples().empty() ? Quantity()
                                               : Quantity::integer(mean.sum()[channel]);
             },
             [=](NumberDescription &number, const State &state) {
                 const SampleMean &mean = meanIn(state);
                 number.formula
                     = mean.samples().empty() ? QString() : sumFormula(title, mean, channel);
             }});
    }
}

} // namespace pixelplumb
