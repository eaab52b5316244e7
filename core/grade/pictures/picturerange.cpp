// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/picturerange.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool isBetween(const Colour &colour, const Colour &one, const Colour &other)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [least, most] = std::minmax(one.channels[i], other.channels[i]);
        if (colour.channels[i] < least || colour.channels[i] > most)
            return false;
    }
    return true;
}

} // namespace

bool PictureRange::contains(const Picture &found, std::size_t place) const
{
    const bool isOpen = std::ranges::any_of(
        sides, [&](const Picture &side) { return side.covered[place] != sides[0].covered[place]; });
    if (isOpen || (openEdges && openEdges->covered[place] != 0))
        return true;
    if (!found.hasColours)
        return found.covered[place] == sides[0].covered[place];
    const auto isIn = [&](std::size_t least, std::size_t most) {
        return isBetween(found.colours[place], sides[least].colours[place],
                         sides[most].colours[place]);
    };
    return isIn(0, 1) || isIn(2, 3);
}

} // namespace pixelplumb
