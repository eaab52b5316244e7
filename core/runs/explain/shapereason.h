// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/pixelhistory.h"

namespace pixelplumb {

/// What the step of the pixel's last visit says of its sample; empty if it says nothing, or if
/// there is none.
QString visitText(const PixelAttempt &attempt, const ScanTrace &trace);

/// Whether a triangle's outline, in place of its edges, decides which samples are written.
bool isDecidedByOutline(const PixelAttempt &attempt, const ScanTrace &trace);

/// Whether a method that tests the samples of a box did not come to this one.
bool isUntested(const PixelAttempt &attempt, const ScanTrace &trace);

// Sentences about a pixel, each after a space; empty where there is nothing to say.

/// " Column 3: p_k = 0, a tie: step diagonally to the pixel (3, 9); …" For a line or an outline
/// that passes beside the pixel: the step that decided there. For what is walked along, such as a
/// circle: the steps of the adjacent pixels, or else of the nearest. For what is filled row by row:
/// the row.
QString stepBesideText(const PixelAttempt &attempt, const TracedScene &traced);

/// The numbers by which the step chose the pixel that wrote it.
QString stepOfPixelText(const PixelAttempt &attempt, const TracedScene &traced);

/// Says that the truth has its own rule where no distance decides: a sample on an edge of a
/// polygon, a line midway between two pixels.
QString tieOfShapeText(const PixelAttempt &attempt, const TracedScene &traced);

/// How the primitive that a set-up drew differs from the given one; empty if it does not.
QString approximationText(const ScanTrace &trace, std::size_t primitive);

} // namespace pixelplumb
