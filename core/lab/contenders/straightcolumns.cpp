// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightloop.h"
#include "core/number/fixedpoint.h"

#include <algorithm>
#include <utility>

/// The assignment's column scan in numbers that round, and the row walk as its turned twin.
namespace pixelplumb {

namespace {

template <std::floating_point Float>
struct Real {
    using Number = Float;
    static Float of(Lattice units) { return Float(units) / Float(unitsPerPixel); }
    static Float whole(std::int64_t integer) { return Float(integer); }
    static std::int64_t floor(Float v) { return straightFloor(v); }
    static std::int64_t ceil(Float v) { return straightCeil(v); }
    static QRgb pixel(const Float (&level)[3])
    {
        return qRgb(byteOf(level[0]), byteOf(level[1]), byteOf(level[2]));
    }
};

template <class Fixed>
struct Binary {
    using Number = Fixed;
    static Fixed of(Lattice units) { return Fixed::fromBinaryFraction(units, unitsPerPixel); }
    static Fixed whole(std::int64_t integer) { return Fixed::fromInteger(integer); }
    static std::int64_t floor(Fixed v) { return v.floor(); }
    static std::int64_t ceil(Fixed v) { return v.ceil(); }
    static QRgb pixel(const Fixed (&level)[3])
    {
        const auto nearest
            = [](Fixed value) { return (value + Fixed::fromBinaryFraction(1, 2)).floor(); };
        return pixelOfLevels({nearest(level[0]), nearest(level[1]), nearest(level[2])});
    }
};

/// y and R G B along an edge, in a number that rounds.
template <class N>
struct Edge {
    using Number = typename N::Number;
    Number y, slope = N::whole(0);
    Number level[3], rate[3];

    Edge(const Vertex &a, const Vertex &b, std::int64_t column)
    {
        const Number width = N::of(b.position.x) - N::of(a.position.x);
        const Number run = N::whole(column) - N::of(a.position.x);
        if (b.position.x != a.position.x)
            slope = (N::of(b.position.y) - N::of(a.position.y)) / width;
        y = N::of(a.position.y) + run * slope;
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = a.colour.channels[i];
            rate[i] = N::whole(0);
            if (b.position.x != a.position.x)
                rate[i] = N::whole(b.colour.channels[i] - from) / width;
            level[i] = N::whole(from) + run * rate[i];
        }
    }

    void step()
    {
        y = y + slope;
        for (std::size_t i = 0; i < 3; ++i)
            level[i] = level[i] + rate[i];
    }
};

template <class N, StraightRule rule>
void drawColumn(std::int64_t x, const Edge<N> &bottom, const Edge<N> &top, RawFrame frame)
{
    using Number = typename N::Number;
    const std::int64_t first = N::ceil(bottom.y);
    const std::int64_t end = rule == StraightRule::Closed ? N::floor(top.y) + 1 : N::ceil(top.y);
    const Number height = top.y - bottom.y;
    const Number start = N::whole(first) - bottom.y;
    Number level[3], rate[3];
    for (std::size_t i = 0; i < 3; ++i) {
        rate[i] = height == N::whole(0) ? N::whole(0) : (top.level[i] - bottom.level[i]) / height;
        level[i] = bottom.level[i] + start * rate[i];
    }
    QRgb *pixel = frame.at(x, first);
    for (std::int64_t y = first; y < end; ++y) {
        *pixel = N::pixel(level);
        pixel += frame.perV;
        level[0] = level[0] + rate[0];
        level[1] = level[1] + rate[1];
        level[2] = level[2] + rate[2];
    }
}

template <class N, StraightRule rule>
void drawRounded(const Triangle &triangle, RawFrame frame)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(i0)];
    const Vertex &p1 = triangle.vertices[std::size_t(i1)];
    const Vertex &p2 = triangle.vertices[std::size_t(i2)];
    const bool longAbove = doubledArea(p0.position, p1.position, p2.position) >= 0;
    const std::int64_t begin = ceilPixel(p0.position.x);
    const std::int64_t middle = ceilPixel(p1.position.x);
    const std::int64_t end = straightEnd(rule, p2.position.x);
    Edge<N> longEdge(p0, p2, begin);
    const auto isAbove = [&](const Edge<N> &shortEdge) {
        if (rule != StraightRule::Closed || longEdge.y == shortEdge.y)
            return longAbove;
        return shortEdge.y < longEdge.y;
    };
    const auto walk = [&](Edge<N> shortEdge, std::int64_t from, std::int64_t to) {
        for (std::int64_t x = from; x < to; ++x) {
            const bool above = isAbove(shortEdge);
            drawColumn<N, rule>(x, above ? shortEdge : longEdge, above ? longEdge : shortEdge,
                                frame);
            shortEdge.step();
            longEdge.step();
        }
    };
    walk(Edge<N>(p0, p1, begin), begin, middle);
    walk(Edge<N>(p1, p2, middle), middle, end);
}

template <class N>
constexpr StraightLoop row(const char *method, Arithmetic arithmetic, SpanAxis axis)
{
    return {method, arithmetic, axis, drawRounded<N, StraightRule::Closed>,
            drawRounded<N, StraightRule::HalfOpen>};
}

constexpr StraightLoop rows[] = {
    row<Real<float>>("column-scan", Arithmetic::Float32, SpanAxis::Column),
    row<Real<double>>("column-scan", Arithmetic::Float64, SpanAxis::Column),
    row<Binary<FixedPoint16>>("column-scan", Arithmetic::Fixed16, SpanAxis::Column),
    row<Binary<FixedPoint32>>("column-scan", Arithmetic::Fixed32, SpanAxis::Column),
    row<Real<float>>("row-walk", Arithmetic::Float32, SpanAxis::Row),
    row<Real<double>>("row-walk", Arithmetic::Float64, SpanAxis::Row),
    row<Binary<FixedPoint16>>("row-walk", Arithmetic::Fixed16, SpanAxis::Row),
    row<Binary<FixedPoint32>>("row-walk", Arithmetic::Fixed32, SpanAxis::Row),
};

} // namespace

std::span<const StraightLoop> straightColumns() { return rows; }

} // namespace pixelplumb
