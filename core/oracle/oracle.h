// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"
#include "core/number/quantity.h"
#include "core/scan/boundaryrule.h"

#include <optional>

/// The truth: coverage and colour by edge functions in integers, for each pixel independently.
/// Nothing is incremental, and nothing is shared with the kernels but the vertex and the statement
/// of the rule (BoundaryRule, FrameView): which way y points and where the off-screen point is. So
/// a fault in one is not repeated in the other; what both share is tested separately
/// (tst_fillrules). Coordinates are sample coordinates.
namespace pixelplumb::oracle {

/// How one edge of the triangle, from vertex index to vertex index, judges a sample.
struct EdgeVerdict {
    int from = 0; ///< index in the caller's triangle
    int to = 0;
    /// The edge function in square lattice units: positive inside, 0 on the edge's line, negative
    /// outside.
    Int128 edgeFunction = 0;
    bool accepts = false; ///< under the fill rule
    /// Signed distance along the column from the edge's line to the sample, px, positive inside;
    /// none for a vertical edge.
    Quantity distanceAlongColumn;
    /// Signed distance along the row; none for a horizontal edge.
    Quantity distanceAlongRow;
    /// The perpendicular distance, px, positive inside; nearest double.
    double distance = 0;
};

struct SampleVerdict {
    bool covered = false;
    bool zeroArea = false; ///< then the edges are not meaningful, and `covered` refers to the
                           ///< segment
    std::array<EdgeVerdict, 3> edges; ///< the edges 0–1, 1–2, 2–0
};

/// Coverage under a rule, for any lattice coordinates and any sample within ±2^30 px.
bool covers(const Triangle &triangle, const BoundaryRule &rule, std::int64_t x, std::int64_t y);

/// Coverage with the verdicts of all three edges.
SampleVerdict judge(const Triangle &triangle, const BoundaryRule &rule, std::int64_t x,
                    std::int64_t y);

/// The exact colour levels of the triangle's plane (or segment) at a sample, inside and outside.
std::array<Quantity, 3> colourAt(const Triangle &triangle, std::int64_t x, std::int64_t y);

/// The byte of each level: ⌊v + 1/2⌋ or ⌊v⌋, clamped to 0 … 255.
Colour byteColourAt(const Triangle &triangle, std::int64_t x, std::int64_t y,
                    ByteRounding rounding);

/// The exact numbers of a column: what the assignment's increments would be without rounding.
struct ExactColumn {
    std::int64_t x = 0;
    Quantity yBottom, yTop; ///< px
    std::array<Quantity, 3> colourBottom, colourTop; ///< levels
    std::array<Quantity, 3> colourRate; ///< levels per row; 0 where y_B = y_T and the area is 0
    std::int64_t firstRow = 0, endRow = 0; ///< covered rows under the rule, unclipped
};

/// None where the triangle does not meet the column: x outside [x₀, x₂].
std::optional<ExactColumn> columnAt(const Triangle &triangle, FillRule rule, std::int64_t x);

/// Whether a sample of the column lies exactly on an edge (where rules and roundings differ).
bool hasTie(const Triangle &triangle, std::int64_t x);

/// Draws the true picture of a triangle over the frame's content, in opaque pixels, so that a
/// transparent frame (WrittenFrame) shows what was written.
void draw(const Triangle &triangle, const BoundaryRule &rule, ByteRounding rounding,
          FrameView frame);

} // namespace pixelplumb::oracle
