// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/straightloop.h"

/// The column walk of the straight loops. What they carry along the edges and how they colour a
/// column is their own.
namespace pixelplumb {

template <class Float>
Float straightPixels(Lattice units)
{
    return Float(units) / Float(unitsPerPixel);
}

/// The arithmetic of a float.
template <std::floating_point Float>
struct Real {
    using Number = Float;
    static Float of(Lattice units) { return straightPixels<Float>(units); }
    static Float whole(std::int64_t integer) { return Float(integer); }
    static std::int64_t floor(Float v)
    {
        const auto towardsZero = std::int64_t(v);
        return towardsZero - std::int64_t(Float(towardsZero) > v);
    }
    static std::int64_t ceil(Float v)
    {
        const auto towardsZero = std::int64_t(v);
        return towardsZero + std::int64_t(Float(towardsZero) < v);
    }
    template <class Levels>
    static QRgb pixel(const Levels &level)
    {
        return qRgb(byteOf(level[0]), byteOf(level[1]), byteOf(level[2]));
    }
};

/// Numbers that change from column to column, or from pixel to pixel, by adding.
template <class N, std::size_t count>
using StraightValues = std::array<typename N::Number, count>;

template <class N>
StraightValues<N, 3> straightLevels(const Vertex &vertex)
{
    const auto &[red, green, blue] = vertex.colour.channels;
    return {N::whole(red), N::whole(green), N::whole(blue)};
}

/// The values of an edge where it meets a column, and y behind them, in numbers that round.
template <class N, std::size_t count>
struct RoundedEdge {
    using Number = typename N::Number;
    using Values = StraightValues<N, count>;
    static constexpr bool mayCross = true; ///< y of two edges, where these do not

    StraightValues<N, count + 1> value, rate;

    RoundedEdge(const LatticePoint &a, const Values &atA, const LatticePoint &b, const Values &atB,
                std::int64_t column)
    {
        const Number width = N::of(b.x) - N::of(a.x);
        const Number run = N::whole(column) - N::of(a.x);
        for (std::size_t i = 0; i <= count; ++i) {
            const Number from = i == count ? N::of(a.y) : atA[i];
            const Number to = i == count ? N::of(b.y) : atB[i];
            rate[i] = b.x == a.x ? N::whole(0) : (to - from) / width;
            value[i] = from + run * rate[i];
        }
    }
    RoundedEdge(const Vertex &a, const Vertex &b, std::int64_t column)
        : RoundedEdge(a.position, straightLevels<N>(a), b.position, straightLevels<N>(b), column)
    {
    }
    const RoundedEdge &values() const { return *this; }
    const Number &y() const { return value[count]; }
    std::int64_t floor() const { return N::floor(y()); }
    std::int64_t ceil() const { return N::ceil(y()); }
    void step()
    {
        for (std::size_t i = 0; i <= count; ++i)
            value[i] = value[i] + rate[i];
    }
};

/// The values in a column's first row, and their rates from row to row.
template <class N, std::size_t count>
struct StraightColumn {
    StraightValues<N, count> value, rate;

    StraightColumn(const RoundedEdge<N, count> &bottom, const RoundedEdge<N, count> &top,
                   std::int64_t first)
    {
        const auto height = top.y() - bottom.y();
        const auto start = N::whole(first) - bottom.y();
        for (std::size_t i = 0; i < count; ++i) {
            rate[i]
                = height == N::whole(0) ? N::whole(0) : (top.value[i] - bottom.value[i]) / height;
            value[i] = bottom.value[i] + start * rate[i];
        }
    }
    void step()
    {
        for (std::size_t i = 0; i < count; ++i)
            value[i] = value[i] + rate[i];
    }
};

/// Walks the columns of a triangle that has area. edgeOn(vertex, vertex, column) begins an edge
/// between two vertices, by index; fill(x, first row, end row, bottom, top) draws a column.
template <StraightRule rule, class EdgeOn, class Fill>
void walkStraight(const Triangle &triangle, const EdgeOn &edgeOn, const Fill &fill)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const auto at = [&](int i) { return triangle.vertices[std::size_t(i)].position; };
    const bool longAbove = doubledArea(at(i0), at(i1), at(i2)) >= 0;
    const std::int64_t begin = ceilPixel(at(i0).x), middle = ceilPixel(at(i1).x);
    const std::int64_t end
        = rule == StraightRule::Closed ? floorPixel(at(i2).x) + 1 : ceilPixel(at(i2).x);
    auto longEdge = edgeOn(std::size_t(i0), std::size_t(i2), begin);
    using Edge = decltype(longEdge);
    const auto isAbove = [&]([[maybe_unused]] const Edge &shortEdge) {
        if constexpr (rule == StraightRule::Closed && Edge::mayCross) {
            if (shortEdge.y() != longEdge.y())
                return shortEdge.y() < longEdge.y();
        }
        return longAbove;
    };
    const auto walk = [&](Edge shortEdge, std::int64_t from, std::int64_t to) {
        for (std::int64_t x = from; x < to; ++x) {
            const bool above = isAbove(shortEdge);
            const Edge &bottom = above ? shortEdge : longEdge;
            const Edge &top = above ? longEdge : shortEdge;
            fill(x, bottom.ceil(), rule == StraightRule::Closed ? top.floor() + 1 : top.ceil(),
                 bottom, top);
            shortEdge.step();
            longEdge.step();
        }
    };
    walk(edgeOn(std::size_t(i0), std::size_t(i1), begin), begin, middle);
    walk(edgeOn(std::size_t(i1), std::size_t(i2), middle), middle, end);
}

/// Walks along edges that a triangle's vertices make.
template <StraightRule rule, class Edge, class Fill>
void walkTriangleEdges(const Triangle &triangle, const Fill &fill)
{
    walkStraight<rule>(
        triangle,
        [&](std::size_t from, std::size_t to, std::int64_t column) {
            return Edge(triangle.vertices[from], triangle.vertices[to], column);
        },
        fill);
}

/// Levels by adding: along the edges, and from row to row.
template <class N, class Edge, StraightRule rule>
void drawBetweenEdges(const Triangle &triangle, RawFrame frame)
{
    walkTriangleEdges<rule, Edge>(
        triangle,
        [&](std::int64_t x, std::int64_t first, std::int64_t end, const Edge &bottom,
            const Edge &top) {
            StraightColumn<N, 3> column(bottom.values(), top.values(), first);
            QRgb *pixel = frame.at(x, first);
            for (std::int64_t y = first; y < end; ++y, pixel += frame.perV) {
                *pixel = N::pixel(column.value);
                column.step();
            }
        });
}

} // namespace pixelplumb
