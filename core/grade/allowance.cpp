// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/allowance.h"

#include "core/grade/undecidable.h"

namespace pixelplumb {

PictureSource allowingFor(Arithmetic arithmetic, const PictureSource &source)
{
    const auto draw = [arithmetic, drawn = source.draw](const Scene &scene) {
        std::optional<Picture> picture = drawn(scene);
        const Picture truth = truePictureOf(scene);
        if (!picture || picture->size() != truth.size())
            return picture;
        const auto undecidable = undecidablePixels(scene, *picture, arithmetic);
        for (std::size_t i = 0; i < undecidable.size(); ++i) {
            if (undecidable[i] == 0)
                continue;
            picture->colours[i] = truth.colours[i];
            picture->covered[i] = truth.covered[i];
        }
        return picture;
    };
    return {source.name, draw};
}

} // namespace pixelplumb
