// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/pixelarea.h"

#include "core/number/widequantity.h"
#include "core/shade/squareclip.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// The area of the triangle in the square around pixel (x, y), px²; clipped in units of 1/256 px.
template <class Number>
Number areaAround(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    ClippedPolygon<Number, 13> polygon;
    for (const Vertex &vertex : triangle.vertices)
        polygon.append(Number(vertex.position.x - x * unitsPerPixel),
                       Number(vertex.position.y - y * unitsPerPixel));
    polygon.clipToSquare(halfPixel);
    const Number area = polygon.doubledArea() / Number(2 * unitsPerPixel * unitsPerPixel);
    return area < 0 ? Number(-area) : area;
}

} // namespace

PixelArea::PixelArea(const Triangle &triangle, std::int64_t x, std::int64_t y)
    : m_triangle(&triangle)
    , m_x(x)
    , m_y(y)
{
    double farthest = 1;
    for (const Vertex &vertex : triangle.vertices)
        farthest = std::max({farthest, std::abs(double(vertex.position.x - x * unitsPerPixel)),
                             std::abs(double(vertex.position.y - y * unitsPerPixel))});
    m_area = std::min(areaAround<double>(triangle, x, y), 1.0);
    // A generous bound: each clipped corner is off by some roundings of the farthest coordinate,
    // and the area by that times the length of its border.
    m_error = farthest * std::ldexp(1.0, -44);
}

bool PixelArea::isEmpty() const
{
    return m_area <= m_error && areaAround<BigRational>(*m_triangle, m_x, m_y) == 0;
}

std::uint8_t PixelArea::times(std::uint8_t alpha) const
{
    const double level = m_area * alpha + 0.5;
    const double byte = std::floor(level);
    const double doubt = 255 * m_error;
    if (level - byte > doubt && byte + 1 - level > doubt)
        return std::uint8_t(byte);
    const BigRational exactly
        = areaAround<BigRational>(*m_triangle, m_x, m_y) * int(alpha) + BigRational(1, 2);
    return std::uint8_t(BigInteger(numerator(exactly) / denominator(exactly)));
}

Quantity PixelArea::exact() const
{
    const BigRational area = areaAround<BigRational>(*m_triangle, m_x, m_y);
    return quotientOf(numerator(area), denominator(area));
}

} // namespace pixelplumb
