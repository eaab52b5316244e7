// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/pixelarea.h"

#include "core/number/widequantity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

template <class Number>
struct Point {
    Number x, y;
};

/// The corners of a triangle that was clipped by four half-planes.
template <class Number>
struct ClippedPolygon {
    std::array<Point<Number>, 8> corners;
    std::size_t count = 0;

    void append(const Point<Number> &corner) { corners[count++] = corner; }

    /// Twice the area without its sign.
    Number doubledArea() const
    {
        Number sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Point<Number> &a = corners[i];
            const Point<Number> &b = corners[(i + 1) % count];
            sum += a.x * b.y - b.x * a.y;
        }
        return sum < 0 ? Number(-sum) : sum;
    }
};

/// Keeps what has sign·coordinate <= bound (Sutherland and Hodgman 1974).
template <class Number>
ClippedPolygon<Number> clipped(const ClippedPolygon<Number> &polygon, Number Point<Number>::*axis,
                               int sign, const Number &bound)
{
    ClippedPolygon<Number> kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Point<Number> &a = polygon.corners[i];
        const Point<Number> &b = polygon.corners[(i + 1) % polygon.count];
        const Number toA = bound - sign * (a.*axis);
        const Number toB = bound - sign * (b.*axis);
        if (toA >= 0)
            kept.append(a);
        if ((toA > 0 && toB < 0) || (toA < 0 && toB > 0)) {
            const Number part = toA / (toA - toB);
            kept.append({Number(a.x + (b.x - a.x) * part), Number(a.y + (b.y - a.y) * part)});
        }
    }
    return kept;
}

/// The area of the triangle in the square around the origin; all in units of 1/256 px.
template <class Number>
Number areaAround(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    ClippedPolygon<Number> polygon;
    for (const Vertex &vertex : triangle.vertices)
        polygon.append({Number(vertex.position.x - x * unitsPerPixel),
                        Number(vertex.position.y - y * unitsPerPixel)});
    const Number half = halfPixel;
    for (const int sign : {-1, 1}) {
        polygon = clipped(polygon, &Point<Number>::x, sign, half);
        polygon = clipped(polygon, &Point<Number>::y, sign, half);
    }
    return polygon.doubledArea() / Number(2 * unitsPerPixel * unitsPerPixel);
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
    // Each corner of what was clipped is off by some roundings of the farthest coordinate, amply,
    // and the area by as much times the length of its border.
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
