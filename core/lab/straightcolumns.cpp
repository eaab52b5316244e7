// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/straightloop.h"
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
    static int byte(Float level) { return byteOf(level); }
};

template <class Fixed>
struct Binary {
    using Number = Fixed;
    static Fixed of(Lattice units) { return Fixed::fromBinaryFraction(units, unitsPerPixel); }
    static Fixed whole(std::int64_t integer) { return Fixed::fromInteger(integer); }
    static std::int64_t floor(Fixed v) { return v.floor(); }
    static std::int64_t ceil(Fixed v) { return v.ceil(); }
    static int byte(Fixed level)
    {
        return clampedByte((level + Fixed::fromBinaryFraction(1, 2)).floor());
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

template <class N>
void drawColumn(std::int64_t x, const Edge<N> &bottom, const Edge<N> &top, RawFrame frame)
{
    using Number = typename N::Number;
    const std::int64_t first = N::ceil(bottom.y);
    const std::int64_t last = N::floor(top.y);
    const Number height = top.y - bottom.y;
    const Number start = N::whole(first) - bottom.y;
    Number level[3], rate[3];
    for (std::size_t i = 0; i < 3; ++i) {
        rate[i] = height == N::whole(0) ? N::whole(0) : (top.level[i] - bottom.level[i]) / height;
        level[i] = bottom.level[i] + start * rate[i];
    }
    QRgb *pixel = frame.at(x, first);
    for (std::int64_t y = first; y <= last; ++y) {
        *pixel = qRgb(N::byte(level[0]), N::byte(level[1]), N::byte(level[2]));
        pixel += frame.perV;
        level[0] = level[0] + rate[0];
        level[1] = level[1] + rate[1];
        level[2] = level[2] + rate[2];
    }
}

template <class N>
void drawRounded(const Triangle &triangle, RawFrame frame)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(i0)];
    const Vertex &p1 = triangle.vertices[std::size_t(i1)];
    const Vertex &p2 = triangle.vertices[std::size_t(i2)];
    const bool longAbove = doubledArea(p0.position, p1.position, p2.position) >= 0;
    const std::int64_t begin = ceilPixel(p0.position.x);
    const std::int64_t middle = ceilPixel(p1.position.x);
    const std::int64_t last = floorPixel(p2.position.x);
    Edge<N> longEdge(p0, p2, begin);
    const auto walk = [&](Edge<N> shortEdge, std::int64_t from, std::int64_t to) {
        for (std::int64_t x = from; x < to; ++x) {
            const bool above = longEdge.y == shortEdge.y ? longAbove : shortEdge.y < longEdge.y;
            drawColumn<N>(x, above ? shortEdge : longEdge, above ? longEdge : shortEdge, frame);
            shortEdge.step();
            longEdge.step();
        }
    };
    walk(Edge<N>(p0, p1, begin), begin, middle);
    walk(Edge<N>(p1, p2, middle), middle, last + 1);
}

constexpr StraightLoop rows[] = {
    {"column-scan", Arithmetic::Float32, false, drawRounded<Real<float>>},
    {"column-scan", Arithmetic::Float64, false, drawRounded<Real<double>>},
    {"column-scan", Arithmetic::Fixed16, false, drawRounded<Binary<FixedPoint16>>},
    {"column-scan", Arithmetic::Fixed32, false, drawRounded<Binary<FixedPoint32>>},
    {"row-walk", Arithmetic::Float32, true, drawRounded<Real<float>>},
    {"row-walk", Arithmetic::Float64, true, drawRounded<Real<double>>},
    {"row-walk", Arithmetic::Fixed16, true, drawRounded<Binary<FixedPoint16>>},
    {"row-walk", Arithmetic::Fixed32, true, drawRounded<Binary<FixedPoint32>>},
};

} // namespace

std::span<const StraightLoop> straightColumns() { return rows; }

} // namespace pixelplumb
