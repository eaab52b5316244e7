// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/pixelhistory.h"

namespace pixelplumb {

/// Whether the outline of a triangle decides which of its samples are written, in place of edges.
bool isDecidedByOutline(const PixelAttempt &attempt, const ScanTrace &trace);

// Sentences about a pixel, each after a space; empty where there is nothing to say.

/// " Column 3: p_k = 0, a tie: step diagonally to the pixel (3, 9); …" Where a line or an outline
/// was decided that passes beside the pixel; of what is walked along, as a circle, the steps of the
/// pixels next to it or else of the nearest; of what is filled row by row, the row.
QString stepBesideText(const PixelAttempt &attempt, const ScanTrace &trace, std::int64_t x,
                       std::int64_t y);

/// By which numbers the step chose the pixel that wrote it.
QString stepOfPixelText(const PixelAttempt &attempt, const ScanTrace &trace);

/// That the truth has a rule of its own where no distance decides: a sample on an edge of a
/// polygon, a line midway between two pixels.
QString tieOfShapeText(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                       std::int64_t y);

/// What a set-up made of its primitive that is not the very same; empty where it is.
QString approximationText(const ScanTrace &trace, std::size_t primitive);

} // namespace pixelplumb
