// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/spanheadings.h"

namespace pixelplumb {

std::vector<NumberDescription> spanHeadings(const TracedScene &traced)
{
    std::vector<NumberDescription> headings = traced.trace->numbers().span;
    if (traced.trace->spanCount() == 0)
        return headings;
    // Some titles follow the settings, and so does every span of a run.
    const std::vector<NumberDescription> inForce = traced.trace->spanWords(0).numbers;
    for (std::size_t i = 0; i < inForce.size(); ++i) {
        if (inForce[i].title != headings[i].title)
            headings[i] = inForce[i];
    }
    return headings;
}

} // namespace pixelplumb
