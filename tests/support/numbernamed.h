// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The span's number with this name in files; an empty Quantity if there is none.
inline Quantity spanNumber(const TracedScene &traced, std::size_t span, const QString &id)
{
    const std::vector<NumberDescription> &numbers = traced.method->numbers.span;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i].id == id)
            return traced.trace->span(span).cells[i];
    }
    return {};
}

} // namespace pixelplumb
