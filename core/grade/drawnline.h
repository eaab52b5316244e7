// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

namespace pixelplumb {

struct LinePixel {
    std::int64_t x = 0, y = 0;
    Colour colour;
};

/// A line in sample coordinates and the pixels that its method writes, by x and then y.
struct DrawnLine {
    LatticePoint from, to;
    Colour fromColour, toColour;
    std::vector<LinePixel> pixels;

    bool isSteep() const { return std::abs(to.y - from.y) >= std::abs(to.x - from.x); }
};

/// Whether a scene has lines alone, and needs colours alone.
bool isOfLines(const Scene &scene);

/// The lines' pixels, changed, painted one line after another.
Picture redrawnLines(const Scene &scene, const std::function<void(DrawnLine &line)> &change);

/// The ends exchanged where x, of a steep line y, would fall.
DrawnLine ascending(DrawnLine line);

} // namespace pixelplumb
