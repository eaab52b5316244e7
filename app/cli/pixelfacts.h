// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/pixelreport.h"
#include "core/runs/differencename.h"

/// What a pixel's report says in text and in JSON alike.
namespace pixelplumb::cli {

/// The pixel's colour in the finished picture.
Colour finalColour(const PixelReport &report);
/// The true colour from the primitives that the method draws.
Colour trueColour(const PixelReport &report);
/// The true colour from all primitives of the scene.
Colour trueColourOfAll(const PixelReport &report);
/// The primitives at the pixel that the method does not draw.
QStringList undrawnAt(const PixelReport &report);

/// What a method calls the bounds of its spans, and the samples along them.
struct SpanWords {
    QString place, lower, upper, samples;
};
SpanWords wordsFor(SpanAxis axis);

/// The place in the window's words: "column 27, second half".
QString spanPlaceText(const PixelAttempt &attempt);

} // namespace pixelplumb::cli
