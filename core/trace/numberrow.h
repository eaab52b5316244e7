// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/trace/numberdescription.h"

#include <functional>
#include <utility>
#include <vector>

namespace pixelplumb {

/// One number of a method: its description, and how it is read from the kernel's state. Nothing
/// else is needed to add a number to a method.
template <class State>
struct NumberRow {
    using Read = std::function<Quantity(const State &)>;
    using Specify = std::function<void(NumberDescription &description, const State &)>;

    // Not an aggregate: GCC 12 fails on lists of rows with a default member initializer.
    NumberRow(NumberDescription shown, Read readFrom, Specify specifyIn = {})
        : description(std::move(shown))
        , read(std::move(readFrom))
        , specify(std::move(specifyIn))
    {
    }

    NumberDescription description; ///< holds for every state
    Read read; ///< returns none where the number does not exist in the state
    /// Adapts the description to one state: the edge that bounds this column, the branch that was
    /// taken. Empty where all states share one description.
    Specify specify;
};

/// The numbers of one level (set-up, span or sample) in display order.
template <class State>
using NumberTable = std::vector<NumberRow<State>>;

template <class State>
std::vector<Quantity> cellsOf(const NumberTable<State> &table, const State &state)
{
    std::vector<Quantity> cells;
    cells.reserve(table.size());
    for (const NumberRow<State> &row : table)
        cells.push_back(row.read(state));
    return cells;
}

/// Descriptions that hold for every state.
template <class State>
std::vector<NumberDescription> descriptionsOf(const NumberTable<State> &table)
{
    std::vector<NumberDescription> descriptions;
    for (const NumberRow<State> &row : table)
        descriptions.push_back(row.description);
    return descriptions;
}

/// Descriptions specified for this state.
template <class State>
std::vector<NumberDescription> descriptionsIn(const NumberTable<State> &table, const State &state)
{
    std::vector<NumberDescription> descriptions = descriptionsOf(table);
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].specify)
            table[i].specify(descriptions[i], state);
    }
    return descriptions;
}

} // namespace pixelplumb
