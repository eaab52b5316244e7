// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

/// The truth of antialiased lines and curves: areas and windings of their outlines
/// (strokeoutline.h), in fractions. It shares nothing with the kernel but the definition of a
/// stroke. Sample coordinates.
namespace pixelplumb::oracle {

/// What lines and curves are where nothing asks for their antialiasing.
enum class StrokeTruth {
    NearestPixels, ///< at each step the nearest pixel
    PixelWide, ///< the pixels whose one sample a stroke covers
};

/// Draws the true picture of lines, outlined circles and ellipses, and Bézier curves over the
/// frame's content, in opaque pixels; other shapes are not drawn. With area antialiasing each
/// stroke is blended over the pixels below. With 4 or 16 samples each sample keeps the colour, at
/// that sample, of the last stroke that covers it, and a pixel is their mean; without antialiasing
/// its only sample is its centre.
void drawStrokes(const Primitives &primitives, const ScanSettings &settings,
                 Antialiasing antialiasing, FrameView frame);

/// Whether drawStrokes() draws the shape; all others have only the picture of shapeoracle.h.
bool isStroke(const Shape &shape);

/// Whether the true picture of a shape, antialiased where the appearance asks for it, has any part
/// of the pixel.
bool covers(const Shape &shape, const Appearance &appearance, StrokeTruth strokes,
            FrameOrigin origin, std::int64_t x, std::int64_t y);

} // namespace pixelplumb::oracle
