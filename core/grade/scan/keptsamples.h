// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/scan/redrawing.h"

namespace pixelplumb {

/// Where a triangle lies, as its spans are counted: what decides whether a sample is kept.
struct SpanGeometry {
    explicit SpanGeometry(const Triangle &walked);

    Triangle triangle;
    Lattice x0 = 0, x1 = 0, x2 = 0; ///< of the vertices by x, the coordinate that counts spans
    SampleBox box; ///< the bounding box of the right program, in which x is a column
};

/// A sample of a run.
struct RunSample {
    std::int64_t span = 0, place = 0;
    std::int64_t first = 0, last = 0; ///< of the run
};

/// Whether a sample lies exactly in the span of a vertex.
constexpr bool isAt(const RunSample &sample, Lattice x) { return sample.span * unitsPerPixel == x; }

/// Whether a program draws a sample that a right one draws.
using KeepsSample = std::function<bool(const SpanGeometry &triangle, const RunSample &sample)>;

/// The program that leaves out all other samples, as a redrawing.
Redrawing redrawingThatKeeps(const KeepsSample &keeps);

} // namespace pixelplumb
