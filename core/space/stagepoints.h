// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/exactreal.h"
#include "core/space/facestages.h"

#include <optional>

/// What single points of a face's stages are described by, as used and without rounding.
namespace pixelplumb {

/// The camera's own numbers, from which those of all stages are worked out.
void writeCameraPoint(StagePoint &point, const SpaceScene &scene);

/// What a corner of the clipped polygon has of its vertex, or of the two ends of the edge that is
/// cut: u, v, the levels and the alpha.
void writeCarried(StagePoint &point, const ClippedCorner<double> &corner,
                  const ClippedCorner<ExactReal> *exact);

/// A corner of the clipped polygon without rounding.
struct ExactCorner {
    const ClipVertex<ExactReal> &vertex;
    const std::array<ExactReal, 2> &place; ///< px
    const ExactReal &z; ///< after the division
};

/// A corner on the lattice; beside it where it was before: none where there is no such corner.
void writeSnappedPoint(StagePoint &point, const SnappedCorner &corner,
                       const std::optional<ExactCorner> &exact, int wExponent);

} // namespace pixelplumb
