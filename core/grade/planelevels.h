// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/arithmeticbound.h"
#include "core/grade/redrawing.h"

namespace pixelplumb {

/// What rounding may do to a triangle on that side; exact numbers are read as float64's.
ArithmeticBound boundOn(const RoundingSide &side, const Triangle &triangle);

/// How bytes round: as they do themselves, or as the scene does; never OfScene.
LevelRounding roundingOf(const LevelBytes &bytes, const ScanSettings &settings);

/// R G B of the plane at a sample, px, on a side of what rounding may do, as bytes become of them
/// before they are clamped.
WholeLevels levelsOn(const RoundingSide &side, const ArithmeticBound &bound,
                     const Triangle &triangle, const ScanSettings &settings,
                     const LevelBytes &bytes, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
