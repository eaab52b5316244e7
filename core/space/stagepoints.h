// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/exactreal.h"
#include "core/space/facestages.h"

#include <optional>

/// Writes single points of a face's stages, with and without rounding.
namespace pixelplumb {

/// The camera's own numbers, from which all stages are computed.
void writeCameraPoint(StagePoint &point, const SpaceScene &scene);

/// What a corner of the clipped polygon takes from its vertex, or from both ends of the cut edge:
/// u, v, the levels and alpha.
void writeCarried(StagePoint &point, const ClippedCorner<double> &corner,
                  const ClippedCorner<ExactReal> *exact);

/// An unrounded corner of the clipped polygon.
struct ExactCorner {
    const ClipVertex<ExactReal> &vertex;
    const std::array<ExactReal, 2> &place; ///< px
    const ExactReal &z; ///< after the division
};

/// A corner on the lattice, and the exact corner before snapping; none where that does not exist.
void writeSnappedPoint(StagePoint &point, const SnappedCorner &corner,
                       const std::optional<ExactCorner> &exact, int wExponent);

} // namespace pixelplumb
