// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/placenumbers.h"

/// The numbers of a line's two ends, with which the set-ups of line methods begin.
namespace pixelplumb {

/// One coordinate of an end point: x₀, y₀, x₁, y₁, or u₀ …
template <class State, class Read>
NumberRow<State> endNumber(QChar letter, int end, const QString &toolTip, const Read &read)
{
    return {plainNumber(u"%1_%2"_s.arg(letter).arg(end),
                        QString(letter) + QChar(char16_t(u'₀' + end)), "px",
                        letter + u' ' + toolTip),
            read};
}

/// A vertex' levels: R₀ G₀ B₀.
template <class State, class SetUp>
void appendEndColours(NumberTable<State> &table, int end, Vertex SetUp::*vertex)
{
    const QString digit = QString::number(end);
    appendChannels(
        table,
        plainNumber(u"%_"_s + digit, u'%' + QString(QChar(char16_t(u'₀' + end))), "levels",
                    end == 0 ? u"% of the end that is stored first."_s : u"% of the other end."_s),
        [vertex](const State &setUp, std::size_t channel) {
            return Quantity::integer((setUp.*vertex).colour.channels[channel]);
        });
}

} // namespace pixelplumb
