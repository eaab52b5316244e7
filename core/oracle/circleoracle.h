// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of circles and ellipses, for each pixel independently, by comparing squares of
/// integers.
namespace pixelplumb::oracle {

/// (x/a)² + (y/b)² = 1 around a centre; lattice units, a, b >= 0.
///
/// The outline has two kinds of arcs. On the x-major ones, |slope| <= 1, each column has the pixel
/// nearest to the curve; they reach to the columns nearest to the points with |slope| = 1. On the
/// y-major ones the same holds for rows. Of two equally near pixels, the one farther from the
/// centre is taken, so that the picture is as symmetrical as its centre allows.
class TrueEllipse {
public:
    /// `shape` is a circle or an ellipse.
    explicit TrueEllipse(const Shape &shape);

    bool outlineHolds(std::int64_t x, std::int64_t y) const;
    /// Inside or on the curve.
    bool contains(std::int64_t x, std::int64_t y) const;

private:
    Lattice m_centreX, m_centreY;
    Lattice m_a, m_b;
};

bool ellipseCovers(const Shape &shape, std::int64_t x, std::int64_t y);
/// Draws it in the first vertex's colour.
void drawEllipse(const Shape &shape, FrameView frame);

} // namespace pixelplumb::oracle
