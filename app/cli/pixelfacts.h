// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/pixelreport.h"
#include "core/runs/differencename.h"

/// What a pixel's report tells as text and as JSON alike.
namespace pixelplumb::cli {

/// The pixel's colour in the finished picture.
Colour finalColour(const PixelReport &report);
/// Of what the method draws.
Colour trueColour(const PixelReport &report);
/// Of all primitives of the scene.
Colour trueColourOfAll(const PixelReport &report);
/// The primitives at the pixel that the method does not draw.
QStringList undrawnAt(const PixelReport &report);

/// What a method calls the bounds of its spans, and the samples along them.
struct SpanWords {
    QString place, lower, upper, samples;
};
SpanWords wordsFor(SpanAxis axis);

/// The window's words: "column 27, second half".
QString spanPlaceText(const PixelAttempt &attempt);

} // namespace pixelplumb::cli
