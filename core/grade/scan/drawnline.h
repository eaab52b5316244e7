// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/scan/linebugs.h"
#include "core/scan/lines/linestep.h"

#include <vector>

namespace pixelplumb {

struct Scene;

struct LinePixel {
    std::int64_t x = 0, y = 0;
    Colour colour;
};

/// A line in sample coordinates and its pixels.
struct DrawnLine {
    LatticePoint from, to;
    Colour fromColour, toColour;
    std::vector<LinePixel> pixels = {};

    bool isSteep() const { return lineAxisOf(from, to) == LineAxis::Y; }
    bool isBetweenSamples() const
    {
        return from == latticePixel(floorPixel(from.x), floorPixel(from.y))
            && to == latticePixel(floorPixel(to.x), floorPixel(to.y));
    }
};

/// The pixels that the scene's method writes, sorted by x, then y.
std::vector<LinePixel> pixelsOfMethod(const Scene &alone);

/// What bugs do to the pixels of any method, whose steps go along this axis.
void changePixels(DrawnLine &line, const LineBugs &bugs, LineAxis steps);

} // namespace pixelplumb
