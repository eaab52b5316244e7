// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of Bézier curves, by distance: a pixel is the curve's where a point of the curve is
/// nearer to it than ½ px, distance being |Δx| + |Δy|; of two pixels to which a point is exactly
/// ½ px near the upper one, the right one. The pixels nearest to the two ends belong to it too, and
/// keep a curve that is smaller than a pixel.
///
/// These are the pixels whose diamond the curve meets. Where it is flatter than 45° that is the
/// nearest pixel on each column, where it is steeper the nearest one on each row: the truth of
/// lines (lineoracle.h), of which a curve is the general case. The diamonds and those between them
/// tile the plane, and the four pixels around one of these are neighbours, so a curve has no gaps.
/// The pixels to which any point of the curve rounds are more, a path by edges without a diagonal
/// step; no thin curve has them all (resources/misprints.md).
///
/// It is decided exactly. With a = x + y and b = y − x a diamond is a unit square, and the curve is
/// halved until it is seen which squares a piece visits. Only where a and b reach the borders of
/// squares at one parameter value, or one touches a border, halving alone never ends; but two
/// distinct roots of an integer polynomial of degree n and Mahler measure M are more than
/// √3·n^(−(n+2)/2)·M^(1−n) apart (K. Mahler, An inequality for the discriminant of a polynomial,
/// 1964), and a Bernstein polynomial whose coefficients change sign has a root in the disc over its
/// interval (Obreschkoff). A piece shorter than that bound for the product of both coordinates,
/// each counted from its border, holds one root alone, which they share.
namespace pixelplumb::oracle {

bool curveCovers(const Shape &curve, std::int64_t x, std::int64_t y);
/// In the first vertex's colour.
void drawCurve(const Shape &curve, FrameView frame);

} // namespace pixelplumb::oracle
