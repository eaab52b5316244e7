// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

/// The truth of antialiased lines and curves: areas and windings of their outlines
/// (strokeoutline.h), in fractions. It shares nothing with the kernel but the statement of what a
/// stroke is. Sample coordinates.
namespace pixelplumb::oracle {

/// Draws the true picture of lines, outlined circles and ellipses, and Bézier curves over what the
/// frame holds, in opaque pixels; other shapes are not drawn. By area each stroke is blended over
/// what stands there. With 4 or 16 samples each sample keeps the colour of the last stroke that
/// covers it, as the stroke has it at the sample, and a pixel is their mean.
void drawStrokes(const Primitives &primitives, const ScanSettings &settings,
                 Antialiasing antialiasing, FrameView frame);

/// Whether that picture has the shape; else it has none but the one of shapeoracle.h.
bool isStroke(const Shape &shape);

/// Whether the true picture of a shape, antialiased where the appearance asks for it, has anything
/// of the pixel.
bool covers(const Shape &shape, const Appearance &appearance, FrameOrigin origin, std::int64_t x,
            std::int64_t y);

} // namespace pixelplumb::oracle
