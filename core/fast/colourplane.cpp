// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/colourplane.h"

#include "core/geometry/levelplane.h"
#include "core/number/three.h"

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
    const auto [p0, p1, p2] = threeOf([&](std::size_t corner) {
        Vertex vertex{{batch.x[corner][i], batch.y[corner][i]}, {}};
        for (std::size_t channel = 0; channel < 3; ++channel)
            vertex.colour.channels[channel]
                = std::uint8_t(batch.colour[corner][i] >> (8 * channel));
        return vertex;
    });
    const LevelPlane<Int128> plane(p0, p1, p2);
    const Int128 along = Int128(batch.firstColumn[i]) * unitsPerPixel - p0.position.x;
    const Int128 up = Int128(batch.firstRow[i]) * unitsPerPixel - p0.position.y;
    const std::uint64_t steps = std::uint64_t(batch.endColumn[i] - batch.firstColumn[i])
        + std::uint64_t(batch.endRow[i] - batch.firstRow[i]);
    const std::uint64_t half
        = rounding == ByteRounding::Nearest ? std::uint64_t(1) << (wideFractionBits - 1) : 0;

    ColourPlane words;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // |numerators| < 2^58 (resources/numerics.md, 3.3), times 2^56: below 2^114.
        words.start[channel]
            = wordOf(plane.numerator(p0, channel, along, up), plane.area) + half + steps;
        words.perColumn[channel] = wordOf(plane.perX[channel] * unitsPerPixel, plane.area);
        words.perRow[channel] = wordOf(plane.perY[channel] * unitsPerPixel, plane.area);
    }
    return words;
}

} // namespace pixelplumb
