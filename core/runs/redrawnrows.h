// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace pixelplumb {

/// Rows of a frame, [first, end).
struct FrameRows {
    std::int64_t first = 0;
    std::int64_t end = 0;

    friend bool operator==(const FrameRows &, const FrameRows &) = default;
};

FrameRows allRowsOf(const FrameSpec &frame);
/// The rows that a triangle may reach by rounding, in sample coordinates; also outside the frame.
FrameRows rowsReachedBy(const Triangle &triangle);

/// Moves a scene's triangle to sample coordinates, by its frame's offset (sampleOffset).
Triangle onSamples(Triangle triangle, Lattice offset);

/// Whether rows can be drawn separately: it must be known which triangles reach into them.
bool isDrawnByRows(const Scene &scene, const Method &method);

/// The rows in which the pictures of two scenes that are drawn by rows may differ: all of them if
/// the scenes differ in more than the positions and colours of triangles.
FrameRows rowsThatDiffer(const Scene &scene, const Scene &other);

} // namespace pixelplumb
