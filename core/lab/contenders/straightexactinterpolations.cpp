// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightedge.h"
#include "core/lab/contenders/straightloop.h"

#include <algorithm>

/// The plane equation and the barycentric form in 64-bit fractions, for R G B only. The bilinear
/// form has no such loop: its quotients along two edges take 128 bits, and only the plane would
/// avoid them.
namespace pixelplumb {

namespace {

/// a·x + b·y + c over a denominator that the triangle's forms share.
struct Linear {
    std::int64_t a = 0, b = 0, c = 0;

    std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
};

/// ⌊sum / denominator + ½⌋ of each; sums inside are not negative.
QRgb nearestPixel(std::int64_t red, std::int64_t green, std::int64_t blue, std::int64_t denominator)
{
    const auto nearest
        = [&](std::int64_t sum) { return (2 * sum + denominator) / (2 * denominator); };
    return pixelOfLevels({nearest(red), nearest(green), nearest(blue)});
}

/// The plane of each channel.
struct Planes {
    Linear channel[3];
    std::int64_t area;

    explicit Planes(const Triangle &triangle)
        : area(std::int64_t(doubledArea(triangle)))
    {
        const auto &[p, q, r] = triangle.vertices;
        const std::int64_t sign = area < 0 ? -1 : 1;
        area *= sign;
        const std::int64_t x1 = q.position.x - p.position.x, y1 = q.position.y - p.position.y;
        const std::int64_t x2 = r.position.x - p.position.x, y2 = r.position.y - p.position.y;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t c0 = p.colour.channels[i];
            const std::int64_t c1 = q.colour.channels[i] - c0, c2 = r.colour.channels[i] - c0;
            const std::int64_t a = sign * (c1 * y2 - c2 * y1), b = sign * (c2 * x1 - c1 * x2);
            channel[i] = {a * unitsPerPixel, b * unitsPerPixel,
                          c0 * area - a * p.position.x - b * p.position.y};
        }
    }

    QRgb pixel(std::int64_t x, std::int64_t y) const
    {
        return nearestPixel(channel[0].at(x, y), channel[1].at(x, y), channel[2].at(x, y), area);
    }
};

/// The weight of each vertex.
struct Weights {
    Linear weight[3];
    std::int64_t level[3][3]; ///< [vertex][channel]
    std::int64_t area;

    explicit Weights(const Triangle &triangle)
        : area(std::int64_t(doubledArea(triangle)))
    {
        const std::int64_t sign = area < 0 ? -1 : 1;
        area *= sign;
        for (std::size_t v = 0; v < 3; ++v) {
            const LatticePoint &p = triangle.vertices[(v + 1) % 3].position;
            const LatticePoint &q = triangle.vertices[(v + 2) % 3].position;
            const std::int64_t a = sign * (p.y - q.y), b = sign * (q.x - p.x);
            weight[v] = {a * unitsPerPixel, b * unitsPerPixel, -a * p.x - b * p.y};
            for (std::size_t i = 0; i < 3; ++i)
                level[v][i] = triangle.vertices[v].colour.channels[i];
        }
    }

    QRgb pixel(std::int64_t x, std::int64_t y) const
    {
        const std::int64_t w[3] = {weight[0].at(x, y), weight[1].at(x, y), weight[2].at(x, y)};
        const auto sum = [&](std::size_t i) {
            return w[0] * level[0][i] + w[1] * level[1][i] + w[2] * level[2][i];
        };
        return nearestPixel(sum(0), sum(1), sum(2), area);
    }
};

template <class Colours, StraightRule rule>
void drawInterpolatedExactly(const Triangle &triangle, RawFrame frame)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(i0)];
    const Vertex &p1 = triangle.vertices[std::size_t(i1)];
    const Vertex &p2 = triangle.vertices[std::size_t(i2)];
    const bool longAbove = doubledArea(p0.position, p1.position, p2.position) >= 0;
    const Colours colours(triangle);
    const std::int64_t begin = ceilPixel(p0.position.x);
    const std::int64_t middle = ceilPixel(p1.position.x);
    const std::int64_t endColumn = straightEnd(rule, p2.position.x);
    StraightEdge longEdge(p0, p2, begin);
    const auto walk = [&](StraightEdge shortEdge, std::int64_t first, std::int64_t end) {
        for (std::int64_t x = first; x < end; ++x) {
            const std::int64_t low = (longAbove ? shortEdge : longEdge).ceil();
            const StraightEdge &top = longAbove ? longEdge : shortEdge;
            const std::int64_t endRow = rule == StraightRule::Closed ? top.whole + 1 : top.ceil();
            QRgb *pixel = frame.at(x, low);
            for (std::int64_t y = low; y < endRow; ++y, pixel += frame.perV)
                *pixel = colours.pixel(x, y);
            shortEdge.step();
            longEdge.step();
        }
    };
    walk(StraightEdge(p0, p1, begin), begin, middle);
    walk(StraightEdge(p1, p2, middle), middle, endColumn);
}

using enum StraightRule;

constexpr StraightLoop rows[] = {
    {"interpolate-plane", Arithmetic::Exact, SpanAxis::Column,
     drawInterpolatedExactly<Planes, Closed>, drawInterpolatedExactly<Planes, HalfOpen>},
    {"interpolate-barycentric", Arithmetic::Exact, SpanAxis::Column,
     drawInterpolatedExactly<Weights, Closed>, drawInterpolatedExactly<Weights, HalfOpen>},
};

} // namespace

std::span<const StraightLoop> straightExactInterpolations() { return rows; }

} // namespace pixelplumb
