// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/oracle/effecttruth.h"
#include "core/scan/boundaryrule.h"

#include <vector>

/// The truth of effects, for every pixel by itself: coverage by oracle::covers, all that is
/// interpolated as fractions of whole numbers of any size (exactsample.h), areas by clipping in
/// rational numbers (squarearea.h), light in 50 digits (lighttruth.h). Nothing is shared with the
/// kernels but the vertex types and the statements of what counts. Sample coordinates.
namespace pixelplumb::oracle {

/// A pixel's column and row.
using PixelPlace = std::array<std::int64_t, 2>;

/// Draws the true picture of the triangles over what the frame holds, in opaque pixels, and
/// returns the pixels in which some light lies too near to the limit between two bytes to be told
/// on which side (LitColour). Shapes are not drawn.
///
/// With 4 or 16 samples all vertices move by the sample's offset; the off-screen point of the fill
/// rule stays. A triangle without area, which has no share of a pixel, paints under the closed rule
/// the pixels whose own sample lies on its segment, whole. With the area, a sample that lies
/// outside of a triangle in perspective, on the horizon of its plane or beyond, draws nothing.
std::vector<PixelPlace> drawEffects(const Primitives &primitives, const ScanSettings &settings,
                                    const EffectTruth &what, FrameView frame);

/// Whether a triangle covers something of a pixel: a part of its square where areas are drawn, one
/// of its samples where these are 4 or 16, else its own.
bool coversPart(const Triangle &triangle, const BoundaryRule &rule, Antialiasing antialiasing,
                std::int64_t x, std::int64_t y);

/// ⌊(s·α + d·(255 − α))/255 + ½⌋ a channel.
Colour blended(const Colour &source, std::uint8_t alpha, const Colour &destination);

/// Where a pixel has its samples, lattice units from its own: one at its centre, or Direct3D's
/// standard patterns of 4 and 16, y upward.
std::vector<LatticePoint> sampleOffsets(Antialiasing antialiasing);

} // namespace pixelplumb::oracle
