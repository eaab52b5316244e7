// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/carriednumbers.h"

#include <QStringList>

namespace pixelplumb {

std::vector<std::size_t> carriedNumbers(const TracedScene &traced, std::size_t primitive)
{
    static const QStringList ids = {"z", "w", "u", "v", "N_x", "N_y", "N_z"};
    const Primitives &primitives = traced.primitives;
    // Effects compute what they call for on every triangle; u and v of lines and circles differ.
    const bool isGiven = primitives.isTriangle(primitive)
        && (traced.shading() || primitives.attributesOf(primitive));
    std::vector<std::size_t> places;
    const std::vector<NumberDescription> &numbers = traced.trace->numbers().sample;
    for (std::size_t i = 0; isGiven && i < numbers.size(); ++i) {
        if (ids.contains(numbers[i].id))
            places.push_back(i);
    }
    return places;
}

} // namespace pixelplumb
