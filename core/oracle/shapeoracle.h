// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

/// The truth of all primitives but triangles, for each pixel independently, in integers. Sample
/// coordinates.
namespace pixelplumb::oracle {

/// Whether the shape's true picture holds the pixel. Point: the nearest pixel. Line: on each column
/// (each row where it is steep) the nearest pixel, in a tie the upper (right) one (lineoracle.h).
/// Outlined circle or ellipse: the same on its x-major and y-major arcs, but ties away from the
/// centre; filled: the samples inside or on the boundary (circleoracle.h). Bézier curve: the pixels
/// that it comes nearer to than ½ px (curveoracle.h); filled path of curves: the samples inside
/// (filledcurveoracle.h). Outlined polygon: the lines of its edges; filled: the samples inside,
/// those on the boundary by the top-left rule, where the frame's origin says which way is down
/// (polygonoracle.h). Text: the samples inside its outlines.
bool covers(const Shape &shape, FrameOrigin origin, std::int64_t x, std::int64_t y);

/// Draws the true picture of a shape over the frame's content, in opaque pixels.
void draw(const Shape &shape, ByteRounding rounding, FrameView frame);

} // namespace pixelplumb::oracle
