// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/glyphpen.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// The farthest that a chord may deviate from its curve, lattice units.
constexpr double farthestFromCurve = double(unitsPerPixel) / 32;
constexpr std::int64_t mostChords = 4096;

/// n equal steps of chords deviate from a curve by at most |second difference| · d(d − 1)/(8 n²),
/// where d is its degree.
template <std::size_t Count>
std::int64_t chordsFor(const std::array<FontPoint, Count> &points, double unitsPerFontUnit)
{
    double largest = 0;
    for (std::size_t i = 0; i + 2 < Count; ++i) {
        const auto x = double(points[i].x - 2 * points[i + 1].x + points[i + 2].x);
        const auto y = double(points[i].y - 2 * points[i + 1].y + points[i + 2].y);
        largest = std::max(largest, std::hypot(x, y));
    }
    constexpr auto degree = double(Count - 1);
    const double chords
        = std::sqrt(largest * unitsPerFontUnit * degree * (degree - 1) / (8 * farthestFromCurve));
    return std::clamp(std::int64_t(std::ceil(std::min(chords, double(mostChords)))),
                      std::int64_t(1), mostChords);
}

constexpr Int128 nearest(Int128 numerator, Int128 denominator)
{
    return floorDivide<Int128>(2 * numerator + denominator, 2 * denominator);
}

} // namespace

void GlyphPen::moveTo(const FontPoint &point)
{
    if (!m_polygon->vertices.empty())
        m_polygon->laterContours.push_back(m_polygon->vertices.size());
    lineTo(point);
}

void GlyphPen::lineTo(const FontPoint &point)
{
    m_pen = point;
    append(point.x, point.y, 1);
}

void GlyphPen::quadraticTo(const FontPoint &control, const FontPoint &end)
{
    curveTo<3>({m_pen, control, end});
}

void GlyphPen::cubicTo(const FontPoint &control1, const FontPoint &control2, const FontPoint &end)
{
    curveTo<4>({m_pen, control1, control2, end});
}

template <std::size_t Count>
void GlyphPen::curveTo(const std::array<FontPoint, Count> &points)
{
    const double unitsPerFontUnit = std::abs(double(m_scale.height)) / double(m_scale.unitsPerEm);
    const std::int64_t chords = chordsFor(points, unitsPerFontUnit);
    for (std::int64_t step = 1; step <= chords; ++step) {
        // De Casteljau's construction at step / chords, without divisions.
        std::array<Int128, Count> x;
        std::array<Int128, Count> y;
        for (std::size_t i = 0; i < Count; ++i) {
            x[i] = points[i].x;
            y[i] = points[i].y;
        }
        Int128 denominator = 1;
        for (std::size_t left = Count - 1; left > 0; --left) {
            for (std::size_t i = 0; i < left; ++i) {
                x[i] = x[i] * (chords - step) + x[i + 1] * step;
                y[i] = y[i] * (chords - step) + y[i + 1] * step;
            }
            denominator *= chords;
        }
        append(x[0], y[0], denominator);
    }
    m_pen = points.back();
}

void GlyphPen::append(Int128 x, Int128 y, Int128 denominator)
{
    const Int128 whole = denominator * m_scale.unitsPerEm;
    const Int128 right = nearest((x + m_origin * denominator) * absolute(m_scale.height), whole);
    const Int128 up = nearest(y * m_scale.height, whole);
    if (absolute(right) > 4 * Int128(largestCoordinate)
        || absolute(up) > 4 * Int128(largestCoordinate)) {
        m_isWithinRange = false;
        return;
    }
    Vertex vertex = m_pattern;
    vertex.position = {m_scale.start.x + Lattice(right), m_scale.start.y + Lattice(up)};
    m_isWithinRange = m_isWithinRange && pixelplumb::isWithinRange(vertex.position);
    m_polygon->vertices.push_back(vertex);
}

} // namespace pixelplumb
