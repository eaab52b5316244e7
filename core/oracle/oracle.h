// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"
#include "core/number/quantity.h"
#include "core/scan/boundaryrule.h"

#include <optional>

/// The truth: coverage and colour by edge functions in integers, for every pixel by itself. Nothing
/// is incremental, and nothing is shared with the kernels but the vertex and the statement of the
/// rule (BoundaryRule, FrameView): which way y points and where the point off the screen is. So a
/// fault of one is not a fault of the other; what both read is tested by itself (tst_fillrules).
/// Coordinates are sample coordinates.
namespace pixelplumb::oracle {

/// How one edge of the triangle, from vertex index to vertex index, sees a sample.
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
    /// The same along the row; none for a horizontal edge.
    Quantity distanceAlongRow;
    /// The perpendicular distance, px, positive inside; nearest double.
    double distance = 0;
};

struct SampleVerdict {
    bool covered = false;
    bool zeroArea = false; ///< then the edges are not meaningful; covered tells of the segment
    std::array<EdgeVerdict, 3> edges; ///< the edges 0–1, 1–2, 2–0
};

/// Coverage under a rule. Any lattice coordinates, any sample within ±2^30 px.
bool covers(const Triangle &triangle, const BoundaryRule &rule, std::int64_t x, std::int64_t y);

/// Coverage with the reasons of all three edges.
SampleVerdict judge(const Triangle &triangle, const BoundaryRule &rule, std::int64_t x,
                    std::int64_t y);

/// The exact colour levels of the triangle's plane (or segment) at a sample; inside and outside.
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

/// Whether a sample of the column lies exactly on an edge (the place where rules and roundings
/// part).
bool hasTie(const Triangle &triangle, std::int64_t x);

/// Draws the true picture of a triangle over what the frame holds: opaque pixels, so that
/// what was written shows on a transparent one (WrittenFrame).
void draw(const Triangle &triangle, const BoundaryRule &rule, ByteRounding rounding,
          FrameView frame);

} // namespace pixelplumb::oracle
