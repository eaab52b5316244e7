// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightloop.h"

/// The column scan whose pictures are true by proof, and the row walk as its turned twin.
namespace pixelplumb {

namespace {

/// whole + remainder / denominator, 0 <= remainder < denominator.
struct Mixed {
    std::int64_t whole = 0, remainder = 0;

    Mixed() = default;
    Mixed(std::int64_t numerator, std::int64_t denominator)
        : whole(numerator / denominator)
        , remainder(numerator % denominator)
    {
        if (remainder < 0) {
            --whole;
            remainder += denominator;
        }
    }
    std::int64_t ceil() const { return whole + std::int64_t(remainder != 0); }
    void add(const Mixed &rate, std::int64_t denominator)
    {
        whole += rate.whole;
        remainder += rate.remainder;
        if (remainder >= denominator) {
            remainder -= denominator;
            ++whole;
        }
    }
};

struct MixedEdge {
    Mixed y, slope;
    std::int64_t width;

    MixedEdge(const Vertex &a, const Vertex &b, std::int64_t column)
        : width((b.position.x - a.position.x) * unitsPerPixel)
    {
        const std::int64_t rise = b.position.y - a.position.y;
        const std::int64_t run = column * unitsPerPixel - a.position.x;
        if (width == 0) {
            width = unitsPerPixel;
            y = Mixed(a.position.y, width);
            return;
        }
        y = Mixed(a.position.y * (b.position.x - a.position.x) + run * rise, width);
        slope = Mixed(rise * unitsPerPixel, width);
    }
};

/// Quotients and remainders in 64 bits: edges by increments, colours by the plane's increments.
template <StraightRule rule>
void drawExact(const Triangle &triangle, RawFrame frame)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(i0)];
    const Vertex &p1 = triangle.vertices[std::size_t(i1)];
    const Vertex &p2 = triangle.vertices[std::size_t(i2)];
    const std::int64_t x1 = p1.position.x - p0.position.x, y1 = p1.position.y - p0.position.y;
    const std::int64_t x2 = p2.position.x - p0.position.x, y2 = p2.position.y - p0.position.y;
    const std::int64_t sign = x1 * y2 - x2 * y1 < 0 ? -1 : 1;
    const std::int64_t area = sign * (x1 * y2 - x2 * y1);
    std::int64_t from[3], perX[3], perY[3];
    Mixed rate[3];
    for (std::size_t i = 0; i < 3; ++i) {
        from[i] = p0.colour.channels[i];
        const std::int64_t c1 = p1.colour.channels[i] - from[i];
        const std::int64_t c2 = p2.colour.channels[i] - from[i];
        perX[i] = sign * (c1 * y2 - c2 * y1);
        perY[i] = sign * (c2 * x1 - c1 * x2);
        rate[i] = Mixed(perY[i] * unitsPerPixel, area);
    }
    const std::int64_t begin = ceilPixel(p0.position.x);
    const std::int64_t middle = ceilPixel(p1.position.x);
    const std::int64_t endColumn = straightEnd(rule, p2.position.x);
    MixedEdge longEdge(p0, p2, begin);
    const auto walk = [&](MixedEdge shortEdge, std::int64_t first, std::int64_t end) {
        for (std::int64_t x = first; x < end; ++x) {
            const Mixed &bottom = sign > 0 ? shortEdge.y : longEdge.y;
            const Mixed &top = sign > 0 ? longEdge.y : shortEdge.y;
            const std::int64_t low = bottom.ceil();
            const std::int64_t endRow = rule == StraightRule::Closed ? top.whole + 1 : top.ceil();
            const std::int64_t along = x * unitsPerPixel - p0.position.x;
            const std::int64_t up = low * unitsPerPixel - p0.position.y;
            Mixed level[3];
            for (std::size_t i = 0; i < 3; ++i)
                level[i] = Mixed(from[i] * area + perX[i] * along + perY[i] * up, area);
            QRgb *pixel = frame.at(x, low);
            for (std::int64_t y = low; y < endRow; ++y) {
                const auto nearest = [&](const Mixed &each) {
                    return each.whole + std::int64_t(each.remainder >= area - each.remainder);
                };
                *pixel = pixelOfLevels({nearest(level[0]), nearest(level[1]), nearest(level[2])});
                pixel += frame.perV;
                level[0].add(rate[0], area);
                level[1].add(rate[1], area);
                level[2].add(rate[2], area);
            }
            shortEdge.y.add(shortEdge.slope, shortEdge.width);
            longEdge.y.add(longEdge.slope, longEdge.width);
        }
    };
    walk(MixedEdge(p0, p1, begin), begin, middle);
    walk(MixedEdge(p1, p2, middle), middle, endColumn);
}

/// float64, multiplying instead of adding up, with half a quantum of bias.
template <StraightRule rule>
void drawBias(const Triangle &triangle, RawFrame frame)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(i0)];
    const Vertex &p1 = triangle.vertices[std::size_t(i1)];
    const Vertex &p2 = triangle.vertices[std::size_t(i2)];
    const std::int64_t x1 = p1.position.x - p0.position.x, y1 = p1.position.y - p0.position.y;
    const std::int64_t x2 = p2.position.x - p0.position.x, y2 = p2.position.y - p0.position.y;
    const auto area = double(x1 * y2 - x2 * y1);
    double from[3], perX[3], perY[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t c0 = p0.colour.channels[i];
        const std::int64_t c1 = p1.colour.channels[i] - c0, c2 = p2.colour.channels[i] - c0;
        from[i] = double(c0);
        perX[i] = double((c1 * y2 - c2 * y1) * unitsPerPixel) / area;
        perY[i] = double((c2 * x1 - c1 * x2) * unitsPerPixel) / area;
    }
    const double half = 0.5 + 0.25 / (area < 0 ? -area : area);
    struct BiasEdge {
        double y, run, slope = 0, bias;
        BiasEdge(const Vertex &a, const Vertex &b, std::int64_t column)
            : y(double(a.position.y) / unitsPerPixel)
            , run(double(column * unitsPerPixel - a.position.x) / unitsPerPixel)
        {
            const auto width = double(b.position.x - a.position.x);
            if (width != 0)
                slope = double(b.position.y - a.position.y) / width;
            bias = 0.5 / ((width == 0 ? 1 : width) * unitsPerPixel);
        }
    };
    const std::int64_t begin = ceilPixel(p0.position.x);
    const std::int64_t middle = ceilPixel(p1.position.x);
    const std::int64_t endColumn = straightEnd(rule, p2.position.x);
    BiasEdge longEdge(p0, p2, begin);
    const auto walk = [&](BiasEdge shortEdge, std::int64_t first, std::int64_t end) {
        for (std::int64_t x = first; x < end; ++x) {
            const BiasEdge &bottom = area > 0 ? shortEdge : longEdge;
            const BiasEdge &top = area > 0 ? longEdge : shortEdge;
            const std::int64_t low
                = straightCeil(bottom.y + bottom.run * bottom.slope - bottom.bias);
            const double highest = top.y + top.run * top.slope;
            const std::int64_t endRow = rule == StraightRule::Closed
                ? straightFloor(highest + top.bias) + 1
                : straightCeil(highest - top.bias);
            const double along = double(x * unitsPerPixel - p0.position.x) / unitsPerPixel;
            double up = double(low * unitsPerPixel - p0.position.y) / unitsPerPixel;
            double base[3];
            for (std::size_t i = 0; i < 3; ++i)
                base[i] = from[i] + perX[i] * along;
            QRgb *pixel = frame.at(x, low);
            for (std::int64_t y = low; y < endRow; ++y, up += 1) {
                const auto byte = [&](std::size_t i) {
                    const double level = base[i] + up * perY[i] + half;
                    return int(level < 0 ? 0 : level > 255 ? 255 : level);
                };
                *pixel = qRgb(byte(0), byte(1), byte(2));
                pixel += frame.perV;
            }
            shortEdge.run += 1;
            longEdge.run += 1;
        }
    };
    walk(BiasEdge(p0, p1, begin), begin, middle);
    walk(BiasEdge(p1, p2, middle), middle, endColumn);
}

constexpr StraightLoop rows[] = {
    {"column-scan", Arithmetic::Exact, SpanAxis::Column, drawExact<StraightRule::Closed>,
     drawExact<StraightRule::HalfOpen>},
    {"column-scan-bias", Arithmetic::Float64, SpanAxis::Column, drawBias<StraightRule::Closed>,
     drawBias<StraightRule::HalfOpen>},
    {"row-walk", Arithmetic::Exact, SpanAxis::Row, drawExact<StraightRule::Closed>,
     drawExact<StraightRule::HalfOpen>},
};

} // namespace

std::span<const StraightLoop> straightExactColumns() { return rows; }

} // namespace pixelplumb
