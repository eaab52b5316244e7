// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/allowance.h"

#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/picturediff.h"

#include <algorithm>
#include <cstdlib>

namespace pixelplumb {

namespace {

/// Whether bytes differ by at most 1, as by rounding.
bool areNeighbours(const Colour &a, const Colour &b)
{
    return std::ranges::equal(a.channels, b.channels, [](std::uint8_t one, std::uint8_t other) {
        return std::abs(one - other) <= 1;
    });
}

} // namespace

PictureSource allowingFor(const Margin &margin, const PictureSource &source)
{
    const auto draw = [margin, drawn = source.draw](const Scene &scene) {
        Result<Picture> picture = drawn(scene);
        const Picture truth = truePictureOf(scene);
        if (!picture || picture->size() != truth.size())
            return picture;
        const auto undecidable = undecidablePixels(scene, truth, *picture, margin);
        const auto ties = tiesOf(scene);
        for (std::size_t i = 0; i < undecidable.size(); ++i) {
            // On an edge it is open whether a sample is drawn, but not its colour.
            const bool isOtherColour = ties[i] != 0 && picture->hasColours
                && picture->covered[i] != 0 && truth.covered[i] != 0
                && !areNeighbours(picture->colours[i], truth.colours[i]);
            if (undecidable[i] == 0 || isOtherColour)
                continue;
            picture->colours[i] = truth.colours[i];
            picture->covered[i] = truth.covered[i];
        }
        return picture;
    };
    return {source.name, draw};
}

} // namespace pixelplumb
