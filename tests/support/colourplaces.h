// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "tests/support/randomnumbers.h"

#include <QString>

#include <algorithm>
#include <utility>

/// Samples of triangles at which a colour level lies as close as possible to the boundary between
/// two bytes without lying on it: the hardest samples for tests of exact colours.
namespace pixelplumb {

using namespace Qt::StringLiterals;

/// In pixels, to the right and up.
struct Steps {
    std::int64_t right = 0;
    std::int64_t up = 0;
};

/// A triangle from the origin to (x1, y1) and (x2, y2), turning counter-clockwise, and a sample
/// (x, y) inside it, all in units of 1/scale px from the first corner; one channel of colour.
struct ColourPlace {
    std::int64_t x1 = 0, y1 = 0, x2 = 0, y2 = 0;
    std::int64_t x = 0, y = 0;
    std::int64_t scale = 1;
    std::array<std::int64_t, 3> levels = {};

    /// Twice the area.
    Int128 area() const { return Int128(x1) * y2 - Int128(x2) * y1; }
    /// The level times the doubled area: at the sample, and its change per pixel.
    Int128 numerator() const
    {
        return levels[0] * area() + (levels[1] - levels[0]) * (Int128(x) * y2 - Int128(y) * x2)
            + (levels[2] - levels[0]) * (Int128(x1) * y - Int128(y1) * x);
    }
    Int128 perColumn() const
    {
        return (Int128(levels[1] - levels[0]) * y2 - Int128(levels[2] - levels[0]) * y1) * scale;
    }
    Int128 perRow() const
    {
        return (Int128(levels[2] - levels[0]) * x1 - Int128(levels[1] - levels[0]) * x2) * scale;
    }
    std::int64_t exactLevel() const
    {
        return std::int64_t(floorDivide<Int128>(2 * numerator() + area(), 2 * area()));
    }

    /// From the first sample of the bounding box to this one.
    Steps stepsInBox() const
    {
        return {(x - std::min({std::int64_t(0), x1, x2})) / scale,
                (y - std::min({std::int64_t(0), y1, y2})) / scale};
    }
    /// Columns and rows of the bounding box.
    Steps boxInPixels() const
    {
        const Steps before = stepsInBox();
        return {before.right + (std::max({std::int64_t(0), x1, x2}) - x) / scale + 1,
                before.up + (std::max({std::int64_t(0), y1, y2}) - y) / scale + 1};
    }

    /// On the lattice of 1/256 px, with the sample at pixel (0, 0).
    Triangle triangle() const
    {
        const auto vertex = [&](std::int64_t right, std::int64_t up, std::int64_t level) {
            const std::int64_t unit = unitsPerPixel / scale;
            return Vertex{{(right - x) * unit, (up - y) * unit}, {{std::uint8_t(level), 0, 0}}};
        };
        return {{vertex(0, 0, levels[0]), vertex(x1, y1, levels[1]), vertex(x2, y2, levels[2])}};
    }

    QString text() const
    {
        return u"(0, 0) (%1, %2) (%3, %4) at (%5, %6), scale %7, levels %8 %9 %10"_s.arg(x1)
            .arg(y1)
            .arg(x2)
            .arg(y2)
            .arg(x)
            .arg(y)
            .arg(scale)
            .arg(levels[0])
            .arg(levels[1])
            .arg(levels[2]);
    }
};

inline Int128 remainderOf(Int128 value, Int128 modulus)
{
    return ((value % modulus) + modulus) % modulus;
}

/// The t in [0, modulus) with value·t ≡ 1; value and modulus must be coprime.
inline Int128 inverseOf(Int128 value, Int128 modulus)
{
    Int128 r0 = modulus, r1 = remainderOf(value, modulus), t0 = 0, t1 = 1;
    while (r1 != 0) {
        const Int128 quotient = r0 / r1;
        r0 = std::exchange(r1, r0 - quotient * r1);
        t0 = std::exchange(t1, t0 - quotient * t1);
    }
    return remainderOf(t0, modulus);
}

/// Places the sample where 2·level + 1 differs by 1/A from an even integer, above or below it. With
/// P1, P2 the corners and w a vector with w × P2 = 1, a sample s = k·w + j·P2 has the weights s ×
/// P2 = k and P1 × s = k·(P1 × w) + j·A, so that modulo A the level's numerator is a multiple of k.
/// False if the triangle contains no such sample.
inline bool laySample(ColourPlace &place, std::int64_t side)
{
    const Int128 area = place.area();
    if (area % 2 == 0 || place.x2 == 0 || absolute(greatestCommonDivisor(place.x2, place.y2)) != 1)
        return false;
    const std::int64_t width = absolute(place.x2);
    const Int128 wx = width == 1 ? 0 : inverseOf(place.y2, width);
    const Int128 wy = (wx * place.y2 - 1) / place.x2;
    const Int128 across = place.x1 * wy - place.y1 * wx;
    const Int128 factor = remainderOf((place.levels[1] - place.levels[0])
                                          + (place.levels[2] - place.levels[0]) * (across % area),
                                      area);
    if (area == 1 || greatestCommonDivisor(factor, area) != 1)
        return false;
    const Int128 k = inverseOf(factor, area) * ((area + side) / 2) % area;
    const Int128 j = -floorDivide<Int128>(k * across, area);
    if (k + k * across + j * area > area)
        return false;
    place.x = std::int64_t(k * wx + j * place.x2);
    place.y = std::int64_t(k * wy + j * place.y2);
    return true;
}

/// A random triangle and its hardest sample. The bounding box in units has an area W'·H' of at most
/// 2^bits; the shapes range from flat to steep and from fat to slivers.
inline ColourPlace drawColourPlace(RandomNumbers &random, int bits, std::int64_t scale)
{
    for (;;) {
        // Nearly square boxes are twice as frequent: a steep triangle has few samples.
        const std::int64_t exponent
            = random.oneIn(2) ? bits / 2 : random.in(bits / 4 + 1, bits - bits / 4 - 1);
        const std::int64_t width = std::int64_t(1) << exponent;
        const std::int64_t height = std::int64_t(1) << (bits - exponent);
        std::array<std::int64_t, 3> xs = {};
        std::array<std::int64_t, 3> ys = {};
        for (std::size_t i = 0; i < 3; ++i) {
            xs[i] = random.in(0, width);
            ys[i] = random.in(0, height);
        }
        if (random.oneIn(3)) { // a sliver: the third corner close to the line through the others
            const double along = double(random.in(0, 1000)) / 1000;
            xs[2] = std::clamp<std::int64_t>(
                xs[0] + std::int64_t(along * double(xs[1] - xs[0])) + random.in(-3, 3), 0, width);
            ys[2] = std::clamp<std::int64_t>(
                ys[0] + std::int64_t(along * double(ys[1] - ys[0])) + random.in(-3, 3), 0, height);
        }
        ColourPlace place{xs[1] - xs[0], ys[1] - ys[0], xs[2] - xs[0], ys[2] - ys[0], 0, 0, scale};
        if (place.area() < 0) {
            std::swap(place.x1, place.x2);
            std::swap(place.y1, place.y2);
        }
        for (std::int64_t &level : place.levels)
            level = random.oneIn(3) ? random.in(0, 1) * 255 : random.in(0, 255);
        if (place.area() != 0 && laySample(place, random.oneIn(2) ? 1 : -1))
            return place;
    }
}

} // namespace pixelplumb
