// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/planelevels.h"

#include "core/oracle/oracle.h"

#include <cmath>

namespace pixelplumb {

ArithmeticBound boundOn(const RoundingSide &side, const Triangle &triangle)
{
    const bool isExact = side.arithmetic == Arithmetic::Exact;
    return {triangle, isExact ? Arithmetic::Float64 : side.arithmetic};
}

LevelRounding roundingOf(const LevelBytes &bytes, const ScanSettings &settings)
{
    if (bytes.rounding != LevelRounding::OfScene)
        return bytes.rounding;
    return settings.rounding == ByteRounding::Nearest ? LevelRounding::Nearest
                                                      : LevelRounding::Down;
}

WholeLevels levelsOn(const RoundingSide &side, const ArithmeticBound &bound,
                     const Triangle &triangle, const ScanSettings &settings,
                     const LevelBytes &bytes, std::int64_t x, std::int64_t y)
{
    constexpr double any = 1024; // levels: beyond all bytes
    const bool isExact = side.arithmetic == Arithmetic::Exact;
    const auto exact = oracle::colourAt(triangle, x, y);
    WholeLevels levels;
    for (std::size_t i = 0; i < 3; ++i) {
        const double error = isExact ? 0 : bound.levelError(x, y, i).value_or(any);
        const double level
            = (exact[i].toDouble() + (side.isUpward ? error : -error)) * bytes.full / bytes.of;
        const LevelRounding rounding = roundingOf(bytes, settings);
        const bool isNearest = rounding == LevelRounding::Nearest;
        levels[i] = std::int64_t(rounding == LevelRounding::Up
                                     ? std::ceil(level)
                                     : std::floor(level + (isNearest ? 0.5 : 0)));
    }
    return levels;
}

} // namespace pixelplumb
