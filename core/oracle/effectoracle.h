// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/oracle/effecttruth.h"
#include "core/scan/boundaryrule.h"

#include <vector>

/// The truth of effects, for each pixel independently: coverage by oracle::covers, interpolation in
/// fractions of whole numbers of any size (exactsample.h), areas by clipping in rational numbers
/// (squarearea.h), light in 50 digits (lighttruth.h). It shares nothing with the kernels but the
/// vertex types and the definitions of what is to be drawn. Sample coordinates.
namespace pixelplumb::oracle {

/// A pixel's column and row.
using PixelPlace = std::array<std::int64_t, 2>;

/// Draws the true picture of the triangles over the frame's content, in opaque pixels. Returns the
/// pixels in which some light is too close to the limit between two bytes to decide between them
/// (LitColour). Shapes are not drawn.
///
/// With 4 or 16 samples all vertices move by the sample's offset; the off-screen point of the fill
/// rule stays. A triangle without area, which has no share of a pixel, fully paints under the
/// closed rule the pixels whose own sample lies on its segment. With area antialiasing, a sample
/// outside a triangle in perspective, on the horizon of its plane or beyond, draws nothing.
std::vector<PixelPlace> drawEffects(const Primitives &primitives, const ScanSettings &settings,
                                    const EffectTruth &what, FrameView frame);

/// Whether a triangle covers some of a pixel: a part of its square with area antialiasing, one of
/// its 4 or 16 samples, or else its own sample.
bool coversPart(const Triangle &triangle, const BoundaryRule &rule, Antialiasing antialiasing,
                std::int64_t x, std::int64_t y);

/// ⌊(s·α + d·(255 − α))/255 + ½⌋ for each channel.
Colour blended(const Colour &source, std::uint8_t alpha, const Colour &destination);

/// The positions of a pixel's samples, in lattice units from the pixel's own sample: one at its
/// centre, or Direct3D's standard patterns of 4 and 16, y upward.
std::vector<LatticePoint> sampleOffsets(Antialiasing antialiasing);

} // namespace pixelplumb::oracle
