// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/framereach.h"
#include "core/effects/triangleneeds.h"

namespace pixelplumb {

/// What the primitives of a scene need, counted in one pass over them.
struct NeedsTally {
    struct Touched {
        std::size_t primitives = 0;
        std::int64_t pixels = 0; ///< at most; of each primitive by itself

        void add(std::int64_t touchedPixels)
        {
            ++primitives;
            pixels += touchedPixels;
        }
    };

    PerEffect<Touched> of; ///< all effects but depth
    std::size_t drawn = 0; ///< primitives that reach the frame; the others need nothing
    std::size_t ownColours = 0; ///< drawn shapes whose points have each its own
    std::size_t drawnTriangles = 0;
    std::size_t drawnSegments = 0; ///< triangles without area, but for points
    std::size_t drawnPoints = 0; ///< triangles whose vertices are one
    std::size_t drawnStrokes = 0; ///< lines and curves that antialiasing can draw
    std::size_t outside = 0;
    std::size_t crossing = 0; ///< the frame's border
    std::size_t cutAtNear = 0; ///< triangles of faces that the near plane has cut
    std::size_t mayCross = 0; ///< shapes of which it is not known whether they cross the border

    std::size_t dividingNothing = 0; ///< triangles whose w differ and that carry nothing but z
    TriangleNeeds carried; ///< what the triangles that call for perspective carry, of any of them
    std::vector<const Texture *> textures; ///< each once, at most three
    int lowestAlpha = 255;
    std::vector<const Triangle *> blended;
};

/// Whether antialiasing is needed is asked of what the appearance says, all else of what is drawn.
NeedsTally tallyNeeds(const Primitives &primitives, const SampledFrame &where);

} // namespace pixelplumb
