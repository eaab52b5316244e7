// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberrow.h"

namespace pixelplumb {

/// Fills in a pattern for R, G or B: % in its texts stands for the channel's letter.
QString forChannel(QString text, std::size_t channel);
NumberDescription forChannel(NumberDescription pattern, std::size_t channel);

/// One row for each of R, G and B; `read` is called with the state and the channel.
template <class State, class Read>
void appendChannels(NumberTable<State> &table, const NumberDescription &pattern, const Read &read)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
        table.push_back({forChannel(pattern, channel),
                         [read, channel](const State &state) { return read(state, channel); }});
}

/// Appends the same rows with words that follow the state: `specify` may write % for the letter.
template <class State, class Read, class Specify>
void appendChannels(NumberTable<State> &table, const NumberDescription &pattern, const Read &read,
                    const Specify &specify)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
        table.push_back({forChannel(pattern, channel),
                         [read, channel](const State &state) { return read(state, channel); },
                         [specify, channel](NumberDescription &description, const State &state) {
                             specify(description, state);
                             description = forChannel(std::move(description), channel);
                         }});
}

} // namespace pixelplumb
