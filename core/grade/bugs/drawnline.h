// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

namespace pixelplumb {

struct LinePixel {
    std::int64_t x = 0, y = 0;
    Colour colour;
};

/// A line in sample coordinates and the pixels that its method writes, sorted by x, then y.
struct DrawnLine {
    LatticePoint from, to;
    Colour fromColour, toColour;
    std::vector<LinePixel> pixels;

    bool isSteep() const { return std::abs(to.y - from.y) >= std::abs(to.x - from.x); }
};

/// Whether a scene consists of lines only and needs only colours.
bool isOfLines(const Scene &scene);

/// Paints the lines' pixels, each line changed, one after another.
Picture redrawnLines(const Scene &scene, const std::function<void(DrawnLine &line)> &change);

/// The line with its ends swapped if x, or y of a steep line, would decrease.
DrawnLine ascending(DrawnLine line);

} // namespace pixelplumb
