// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/colourplane.h"

namespace pixelplumb {

namespace {

/// ⌊numerator · 2^56 / denominator⌋ modulo 2^64.
std::uint64_t wordOf(Int128 numerator, Int128 denominator)
{
    return std::uint64_t(floorDivide(numerator * (Int128(1) << wideFractionBits), denominator));
}

} // namespace

std::optional<ColourPlane> ColourPlane::wide(const TriangleBatch &batch, std::size_t i,
                                             ByteRounding rounding)
{
    if (!(batch.resolution[i] < resolutionLimit(wideFractionBits)))
        return std::nullopt;
    const Int128 x0 = batch.x[0][i];
    const Int128 y0 = batch.y[0][i];
    const Int128 x1 = batch.x[1][i] - x0;
    const Int128 y1 = batch.y[1][i] - y0;
    const Int128 x2 = batch.x[2][i] - x0;
    const Int128 y2 = batch.y[2][i] - y0;
    const Int128 signedArea = x1 * y2 - x2 * y1;
    const Int128 sign = signedArea < 0 ? -1 : 1;
    const Int128 area = sign * signedArea;
    const Int128 along = Int128(batch.firstColumn[i]) * unitsPerPixel - x0;
    const Int128 up = Int128(batch.firstRow[i]) * unitsPerPixel - y0;
    const std::uint64_t steps = std::uint64_t(batch.endColumn[i] - batch.firstColumn[i])
        + std::uint64_t(batch.endRow[i] - batch.firstRow[i]);
    const std::uint64_t half
        = rounding == ByteRounding::Nearest ? std::uint64_t(1) << (wideFractionBits - 1) : 0;

    ColourPlane plane;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto level = [&](std::size_t corner) {
            return Int128(batch.colour[corner][i] >> (8 * channel) & 255);
        };
        const Int128 c0 = level(0);
        const Int128 c1 = level(1) - c0;
        const Int128 c2 = level(2) - c0;
        const Int128 gradientX = sign * (c1 * y2 - c2 * y1);
        const Int128 gradientY = sign * (c2 * x1 - c1 * x2);
        // |numerators| < 2^58 (resources/numerics.md, 3.3), times 2^56: below 2^114.
        plane.start[channel]
            = wordOf(c0 * area + gradientX * along + gradientY * up, area) + half + steps;
        plane.perColumn[channel] = wordOf(gradientX * unitsPerPixel, area);
        plane.perRow[channel] = wordOf(gradientY * unitsPerPixel, area);
    }
    return plane;
}

} // namespace pixelplumb
