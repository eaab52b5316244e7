// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

/// The truth of the primitives that are not triangles, for every pixel by itself, in integers.
/// Sample coordinates.
namespace pixelplumb::oracle {

/// Whether the shape's true picture holds the pixel. The pictures: of a point, the nearest pixel;
/// of a line, on each column (on each row where it is steep) the pixel nearest to it, the upper one
/// (the right one) of two that are equally near (lineoracle.h); of an outlined circle or ellipse,
/// the same on its x-major and y-major arcs, but ties away from the centre; of a filled one, the
/// samples inside or on the boundary (circleoracle.h); of a Bézier curve, the pixels that it comes
/// nearer to than ½ px (curveoracle.h), of a filled path of such the samples inside
/// (filledcurveoracle.h); of an outlined polygon, the lines of its edges; of a filled one, the
/// samples inside, those on the boundary by the top-left rule, for which the frame's origin says
/// what is down (polygonoracle.h); of a text, the samples inside its outlines.
bool covers(const Shape &shape, FrameOrigin origin, std::int64_t x, std::int64_t y);

/// Draws the true picture of a shape over what the frame holds, in opaque pixels.
void draw(const Shape &shape, ByteRounding rounding, FrameView frame);

} // namespace pixelplumb::oracle
