// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/seededrandom.h"

#include <vector>

/// The triangles that families are made of. All have area and stay 2 px inside the frame.
namespace pixelplumb::familyshapes {

/// Vertices anywhere on multiples of `step` lattice units (256: whole pixels).
std::vector<Triangle> scattered(SeededRandom &random, const FrameSpec &frame, std::size_t count,
                                Lattice step);
/// Boxes of `smallest` to `largest` px a side, on multiples of `step` lattice units.
std::vector<Triangle> boxed(SeededRandom &random, const FrameSpec &frame, std::size_t count,
                            int smallest, int largest, Lattice step);
/// As long as the frame and 1 to 3 px thick, half of them tall.
std::vector<Triangle> slivers(SeededRandom &random, const FrameSpec &frame, std::size_t count);
/// Edges along small whole vectors, so that each passes through many samples.
std::vector<Triangle> tied(SeededRandom &random, const FrameSpec &frame, std::size_t count);
/// A quarter of the frame and more.
std::vector<Triangle> large(SeededRandom &random, const FrameSpec &frame, std::size_t count);
/// A grid with moved corners at 1/256 px, two triangles a cell, that fills most of the frame.
std::vector<Triangle> mesh(SeededRandom &random, const FrameSpec &frame, int columns, int rows);
/// A sliver along the frame that sinks by 1/16 px from frame to frame.
std::vector<Triangle> slidingSliver(const FrameSpec &frame, std::size_t count);

} // namespace pixelplumb::familyshapes
