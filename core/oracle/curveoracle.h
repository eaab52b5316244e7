// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of Bézier curves, by distance: a pixel belongs to the curve if a point of the curve is
/// nearer to it than ½ px, with |Δx| + |Δy| as distance; of two pixels exactly ½ px from a point,
/// the upper or the right one belongs. So do the pixels nearest to the two ends, which preserve a
/// curve smaller than a pixel.
///
/// These are the pixels whose diamond the curve meets. Where the curve is flatter than 45°, that is
/// the nearest pixel on each column; where it is steeper, the nearest on each row: the truth of
/// lines (lineoracle.h), of which a curve is the general case. The pixels' diamonds and the
/// diamonds between them tile the plane, and the four pixels around one of the latter are
/// neighbours, so a curve has no gaps. The pixels to which any point of the curve rounds are more,
/// a path across pixel edges without a diagonal step; no thin curve has them all
/// (resources/misprints.md).
///
/// The decision is exact. With a = x + y and b = y − x a diamond is a unit square, and the curve is
/// halved until it is clear which squares a piece visits. Halving fails to end only where a and b
/// reach the borders of squares at the same parameter value, or one touches a border; but two
/// distinct roots of an integer polynomial of degree n and Mahler measure M are more than
/// √3·n^(−(n+2)/2)·M^(1−n) apart (K. Mahler, An inequality for the discriminant of a polynomial,
/// 1964), and a Bernstein polynomial whose coefficients change sign has a root in the disc over its
/// interval (Obreschkoff). A piece shorter than that bound for the product of both coordinates,
/// each measured from its border, holds a single root, which they share.
namespace pixelplumb::oracle {

bool curveCovers(const Shape &curve, std::int64_t x, std::int64_t y);
/// Draws it in the first vertex's colour.
void drawCurve(const Shape &curve, FrameView frame);

} // namespace pixelplumb::oracle
