// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/oracle.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb::oracle {

namespace {

template <class Integer>
struct Point {
    Integer x = 0;
    Integer y = 0;
};

/// The edge functions of a triangle, oriented so that they are positive inside.
template <class Integer>
class EdgeFunctions {
public:
    explicit EdgeFunctions(const Triangle &triangle)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &position = triangle.vertices[i].position;
            m_corners[i] = {Integer(position.x), Integer(position.y)};
        }
        const Integer signedArea = function(0, m_corners[2]);
        m_sign = signedArea < 0 ? -1 : 1;
        m_area = signedArea * m_sign;
    }

    /// Doubled, unsigned; the sum of the three values at any point.
    Integer area() const { return m_area; }

    /// The function of the edge from corner `edge` to the next, in square lattice units.
    Integer value(std::size_t edge, const Point<Integer> &sample) const
    {
        return m_sign * function(edge, sample);
    }

    /// Whether a sample exactly on the edge's line counts as inside: by the sign of the function's
    /// change under the rule's infinitely small displacement.
    bool ownsBoundary(std::size_t edge, const BoundaryRule &rule) const
    {
        const Point<Integer> &a = m_corners[edge];
        const Point<Integer> &b = m_corners[(edge + 1) % 3];
        const Integer perX = -m_sign * (b.y - a.y); // change of the function per unit of x
        const Integer perY = m_sign * (b.x - a.x);
        switch (rule.rule) {
        case FillRule::Closed:
            return true;
        case FillRule::HalfOpenColumn: // (+ε², +ε)
            return perY != 0 ? perY > 0 : perX > 0;
        case FillRule::TopLeft: // (+ε, ε² down on screen)
            if (perX != 0)
                return perX > 0;
            return rule.origin == FrameOrigin::TopLeft ? perY > 0 : perY < 0;
        case FillRule::OffScreenPoint:
            return value(edge, {rule.offScreenPoint.x, rule.offScreenPoint.y}) > 0;
        case FillRule::Open:
            return false;
        }
        return false;
    }

private:
    Integer function(std::size_t edge, const Point<Integer> &sample) const
    {
        const Point<Integer> &a = m_corners[edge];
        const Point<Integer> &b = m_corners[(edge + 1) % 3];
        return (b.x - a.x) * (sample.y - a.y) - (b.y - a.y) * (sample.x - a.x);
    }

    std::array<Point<Integer>, 3> m_corners;
    Integer m_sign = 1;
    Integer m_area = 0;
};

template <class Integer>
Point<Integer> samplePoint(std::int64_t x, std::int64_t y)
{
    return {Integer(x) * unitsPerPixel, Integer(y) * unitsPerPixel};
}

/// A triangle of zero area is the segment between its extreme vertices in (x, y) order.
struct Segment {
    explicit Segment(const Triangle &triangle)
    {
        const std::array<int, 3> order = sortedByColumn(triangle);
        first = &triangle.vertices[std::size_t(order[0])];
        last = &triangle.vertices[std::size_t(order[2])];
    }

    bool contains(std::int64_t x, std::int64_t y) const
    {
        const LatticePoint sample = latticePixel(x, y);
        return doubledArea(first->position, last->position, sample) == 0
            && sample >= first->position && sample <= last->position;
    }

    /// The level at a sample on the segment: numerator and denominator > 0.
    std::pair<Int128, Int128> level(std::size_t channel, std::int64_t x, std::int64_t y) const
    {
        const Int128 from = first->colour.channels[channel];
        const Int128 rise = last->colour.channels[channel] - from;
        const Int128 width = last->position.x - first->position.x;
        if (width > 0)
            return {from * width + rise * (Int128(x) * unitsPerPixel - first->position.x), width};
        const Int128 height = last->position.y - first->position.y;
        if (height > 0)
            return {from * height + rise * (Int128(y) * unitsPerPixel - first->position.y), height};
        return {from, 1};
    }

    const Vertex *first;
    const Vertex *last;
};

/// ⌊n/d + 1/2⌋ or ⌊n/d⌋, clamped.
template <class Integer>
std::uint8_t byteOf(Integer numerator, Integer denominator, ByteRounding rounding)
{
    const Integer level = rounding == ByteRounding::Nearest
        ? floorDivide<Integer>(2 * numerator + denominator, 2 * denominator)
        : floorDivide<Integer>(numerator, denominator);
    return std::uint8_t(std::clamp<Integer>(level, 0, 255));
}

/// The level's numerator over the doubled area: barycentric weights times vertex levels.
template <class Integer>
Integer levelNumerator(const Triangle &triangle, std::size_t channel,
                       const std::array<Integer, 3> &values)
{
    Integer sum = 0;
    for (std::size_t edge = 0; edge < 3; ++edge)
        sum += values[edge] * triangle.vertices[(edge + 2) % 3].colour.channels[channel];
    return sum;
}

struct PixelBox {
    std::int64_t firstX, endX, firstY, endY;
};

PixelBox boxWithin(const Triangle &triangle, FrameView frame)
{
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    return {std::max<std::int64_t>(ceilPixel(left), frame.firstColumn),
            std::min(floorPixel(right) + 1, frame.endColumn()),
            std::max<std::int64_t>(ceilPixel(low), frame.firstRow),
            std::min(floorPixel(high) + 1, frame.endRow())};
}

void drawSegment(const Triangle &triangle, ByteRounding rounding, const PixelBox &box,
                 FrameView frame)
{
    const Segment segment(triangle);
    for (std::int64_t y = box.firstY; y < box.endY; ++y) {
        for (std::int64_t x = box.firstX; x < box.endX; ++x) {
            if (!segment.contains(x, y))
                continue;
            *frame.at(x, y) = packed(byteColourAt(triangle, x, y, rounding));
        }
    }
}

template <class Integer>
void drawTriangle(const Triangle &triangle, const BoundaryRule &rule, ByteRounding rounding,
                  const PixelBox &box, FrameView frame)
{
    const EdgeFunctions<Integer> edges(triangle);
    std::array<Integer, 3> least; // the smallest value that is inside
    for (std::size_t edge = 0; edge < 3; ++edge)
        least[edge] = edges.ownsBoundary(edge, rule) ? 0 : 1;
    for (std::int64_t y = box.firstY; y < box.endY; ++y) {
        for (std::int64_t x = box.firstX; x < box.endX; ++x) {
            const Point<Integer> sample = samplePoint<Integer>(x, y);
            const std::array<Integer, 3> values
                = {edges.value(0, sample), edges.value(1, sample), edges.value(2, sample)};
            if (values[0] < least[0] || values[1] < least[1] || values[2] < least[2])
                continue;
            const auto byte = [&](std::size_t channel) {
                return int(byteOf<Integer>(levelNumerator(triangle, channel, values), edges.area(),
                                           rounding));
            };
            *frame.at(x, y) = qRgb(byte(0), byte(1), byte(2));
        }
    }
}

} // namespace

SampleVerdict judge(const Triangle &triangle, const BoundaryRule &rule, std::int64_t x,
                    std::int64_t y)
{
    SampleVerdict verdict;
    const EdgeFunctions<Int128> edges(triangle);
    verdict.zeroArea = edges.area() == 0;
    const Point<Int128> sample = samplePoint<Int128>(x, y);
    verdict.covered = true;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        EdgeVerdict &of = verdict.edges[edge];
        of.from = int(edge);
        of.to = int((edge + 1) % 3);
        of.edgeFunction = edges.value(edge, sample);
        of.accepts
            = of.edgeFunction > 0 || (of.edgeFunction == 0 && edges.ownsBoundary(edge, rule));
        verdict.covered = verdict.covered && of.accepts;
        const LatticePoint &a = triangle.vertices[edge].position;
        const LatticePoint &b = triangle.vertices[(edge + 1) % 3].position;
        const Int128 width = absolute(b.x - a.x);
        const Int128 height = absolute(b.y - a.y);
        if (width != 0)
            of.distanceAlongColumn = Quantity::rational(of.edgeFunction, width * unitsPerPixel);
        if (height != 0)
            of.distanceAlongRow = Quantity::rational(of.edgeFunction, height * unitsPerPixel);
        if (width != 0 || height != 0)
            of.distance = double(of.edgeFunction) / std::hypot(double(width), double(height))
                / double(unitsPerPixel);
    }
    if (verdict.zeroArea)
        verdict.covered = covers(triangle, rule, x, y);
    return verdict;
}

bool covers(const Triangle &triangle, const BoundaryRule &rule, std::int64_t x, std::int64_t y)
{
    const EdgeFunctions<Int128> edges(triangle);
    if (edges.area() == 0)
        return rule.rule == FillRule::Closed && Segment(triangle).contains(x, y);
    const Point<Int128> sample = samplePoint<Int128>(x, y);
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const Int128 value = edges.value(edge, sample);
        if (value < 0 || (value == 0 && !edges.ownsBoundary(edge, rule)))
            return false;
    }
    return true;
}

std::array<Quantity, 3> colourAt(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const EdgeFunctions<Int128> edges(triangle);
    const Point<Int128> sample = samplePoint<Int128>(x, y);
    const std::array<Int128, 3> values
        = {edges.value(0, sample), edges.value(1, sample), edges.value(2, sample)};
    std::array<Quantity, 3> levels;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (edges.area() != 0) {
            levels[channel]
                = Quantity::rational(levelNumerator(triangle, channel, values), edges.area());
            continue;
        }
        const auto [numerator, denominator] = Segment(triangle).level(channel, x, y);
        levels[channel] = Quantity::rational(numerator, denominator);
    }
    return levels;
}

Colour byteColourAt(const Triangle &triangle, std::int64_t x, std::int64_t y, ByteRounding rounding)
{
    Colour colour;
    const std::array<Quantity, 3> levels = colourAt(triangle, x, y);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        colour.channels[channel]
            = byteOf(levels[channel].numerator(), levels[channel].denominator(), rounding);
    }
    return colour;
}

void draw(const Triangle &triangle, const BoundaryRule &rule, ByteRounding rounding,
          FrameView frame)
{
    const PixelBox box = boxWithin(triangle, frame);
    if (doubledArea(triangle) == 0) {
        if (rule.rule == FillRule::Closed)
            drawSegment(triangle, rounding, box, frame);
    } else if (integerWidthFor(triangle) == IntegerWidth::Bits64) {
        drawTriangle<std::int64_t>(triangle, rule, rounding, box, frame);
    } else {
        drawTriangle<Int128>(triangle, rule, rounding, box, frame);
    }
}

} // namespace pixelplumb::oracle
