// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/arithmeticbound.h"
#include "core/grade/scan/redrawing.h"

namespace pixelplumb {

/// The bound of rounding on a triangle, on that side; exact counts as float64.
ArithmeticBound boundOn(const RoundingSide &side, const Triangle &triangle);

/// How levels are rounded to bytes: as `bytes` says, or else as the scene does; never OfScene.
LevelRounding roundingOf(const LevelBytes &bytes, const ScanSettings &settings);

/// R G B of the plane at a sample (px), on a side of rounding, as whole levels before they are
/// clamped to bytes.
WholeLevels levelsOn(const RoundingSide &side, const ArithmeticBound &bound,
                     const Triangle &triangle, const ScanSettings &settings,
                     const LevelBytes &bytes, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
