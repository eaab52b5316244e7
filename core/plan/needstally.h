// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/framereach.h"
#include "core/shade/triangleneeds.h"

namespace pixelplumb {

/// What the primitives of a scene need, counted in one pass over them.
struct NeedsTally {
    struct Touched {
        std::size_t primitives = 0;
        std::int64_t pixels = 0; ///< upper bound; each primitive is counted by itself

        void add(std::int64_t touchedPixels)
        {
            ++primitives;
            pixels += touchedPixels;
        }
    };

    PerEffect<Touched> of; ///< all effects but depth
    std::size_t drawn = 0; ///< primitives that reach the frame; the others need nothing
    std::size_t ownColours = 0; ///< drawn shapes whose points each have their own colour
    std::size_t drawnTriangles = 0;
    std::size_t drawnSegments = 0; ///< triangles without area that are not points
    std::size_t drawnPoints = 0; ///< triangles whose vertices coincide
    /// The triangles, and the lines and curves, that would be drawn with the antialiasing that the
    /// appearance asks for.
    std::size_t askedTriangles = 0;
    std::size_t askedStrokes = 0;
    std::size_t outside = 0;
    bool isPart = false; ///< the method leaves out primitives of the scene
    std::size_t crossing = 0; ///< crossing the frame's border
    std::size_t cutAtNear = 0; ///< pieces of faces cut by the near plane
    std::size_t mayCross = 0; ///< shapes that may cross the border; not known for certain

    std::size_t dividingNothing = 0; ///< triangles whose w differ but that carry nothing but z
    TriangleNeeds carried; ///< what any triangle that calls for perspective carries
    std::vector<const Texture *> textures; ///< each once, at most three
    int lowestAlpha = 255;
    std::vector<const Triangle *> blended;

    /// Whether what is counted is all that the scene has.
    bool isOfAll() const { return outside == 0 && !isPart; }
};

/// Antialiasing is judged by what the appearance asks for, everything else by what is drawn.
NeedsTally tallyNeeds(const Primitives &primitives, const SampledFrame &where);

} // namespace pixelplumb
