// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/strokes/strokearea.h"

#include "core/number/widequantity.h"
#include "core/shade/squareclip.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

StrokePoint sampleOf(const StrokePixel &pixel)
{
    return {pixel.x * strokeUnitsPerPixel, pixel.y * strokeUnitsPerPixel};
}

/// How often the border winds around the point counterclockwise: its upward edges that meet a ray
/// to the right, less the downward ones.
int windingAround(const StrokePoint &point, const StrokeQuad &quad)
{
    int winding = 0;
    for (std::size_t i = 0; i < quad.size(); ++i) {
        const StrokePoint &a = quad[i];
        const StrokePoint &b = quad[(i + 1) % quad.size()];
        const bool goesUp = a.y <= point.y && b.y > point.y;
        const bool goesDown = b.y <= point.y && a.y > point.y;
        if (!goesUp && !goesDown)
            continue;
        const Int128 turn
            = Int128(b.x - a.x) * (point.y - a.y) - Int128(point.x - a.x) * (b.y - a.y);
        if (goesUp && turn > 0)
            ++winding;
        else if (goesDown && turn < 0)
            --winding;
    }
    return winding;
}

} // namespace

bool StrokeCoverage::covers(const LatticePoint &offset) const
{
    const StrokePoint sample = sampleOf(m_pixel.front());
    const StrokePoint point = {sample.x + offset.x * strokeUnitsPerLattice,
                               sample.y + offset.y * strokeUnitsPerLattice};
    int winding = 0;
    for (const StrokePixel &entry : m_pixel)
        winding += windingAround(point, m_quads[entry.quad]);
    return winding > 0;
}

template <class Number>
Number StrokeCoverage::sumOfAreas() const
{
    const StrokePoint sample = sampleOf(m_pixel.front());
    Number doubled = 0;
    for (const StrokePixel &entry : m_pixel) {
        ClippedPolygon<Number, 19> polygon;
        for (const StrokePoint &corner : m_quads[entry.quad])
            polygon.append(Number(corner.x - sample.x), Number(corner.y - sample.y));
        polygon.clipToSquare(Number(strokeHalfPixel));
        doubled += polygon.doubledArea();
    }
    return doubled / Number(2 * strokeUnitsPerPixel * strokeUnitsPerPixel);
}

StrokeCoverage::Share StrokeCoverage::share() const
{
    const StrokePoint sample = sampleOf(m_pixel.front());
    double farthest = 0;
    for (const StrokePixel &entry : m_pixel) {
        for (const StrokePoint &corner : m_quads[entry.quad])
            farthest = std::max({farthest, std::abs(double(corner.x - sample.x)),
                                 std::abs(double(corner.y - sample.y))});
    }
    const double area = sumOfAreas<double>();
    // A generous bound: each clipped corner is off by some roundings of the farthest coordinate,
    // and the area by that times the length of its border.
    const double error = double(m_pixel.size()) * (farthest / double(strokeUnitsPerPixel) + 1)
        * std::ldexp(1.0, -36);
    const double level = 255 * std::clamp(area, 0.0, 1.0) + 0.5;
    const double byte = std::floor(level);
    const double doubt = 255 * error;
    const bool isByteSure = level - byte > doubt && byte + 1 - level > doubt;
    if (isByteSure && area > error)
        return {std::uint8_t(byte), false};
    const BigRational exactly = sumOfAreas<BigRational>();
    if (exactly <= 0)
        return {};
    const BigRational exactLevel
        = (exactly > 1 ? BigRational(1) : exactly) * 255 + BigRational(1, 2);
    return {std::uint8_t(BigInteger(numerator(exactLevel) / denominator(exactLevel))), false};
}

Quantity StrokeCoverage::area() const
{
    const BigRational area = sumOfAreas<BigRational>();
    if (area > 1)
        return Quantity::integer(1);
    return area < 0 ? Quantity::integer(0) : quotientOf(numerator(area), denominator(area));
}

} // namespace pixelplumb
