// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/interpolation/interpolationnumbers.h"

#include <array>
#include <concepts>

namespace pixelplumb {

/// a·x + b·y + c at a sample.
template <class Integer>
FractionOf<Integer> linearAt(const std::array<FractionOf<Integer>, 3> &form, std::int64_t x,
                             std::int64_t y)
{
    return {form[0].numerator * x + form[1].numerator * y + form[2].numerator, form[0].denominator};
}

template <FloatingNumber Float>
Float linearAt(const std::array<Float, 3> &form, std::int64_t x, std::int64_t y)
{
    return form[0] * Float(x) + form[1] * Float(y) + form[2];
}

/// The normal N = ⟨A, B, C⟩ = (P1 − P0) × (P2 − P0) of the plane through the three values of a
/// channel, and D = −N·P0.
template <class Number>
struct PlaneNormal {
    Number a, b, c, d;
};

template <FloatingNumber Float, class Corner>
[[gnu::always_inline]] inline PlaneNormal<Float> planeNormal(const std::array<Corner, 3> &vertices,
                                                             std::size_t channel)
{
    const auto real = [](Lattice units) { return NumberTraits<Float>::fromLattice(units); };
    const auto point = [&](const Corner &vertex) {
        return std::array<Float, 3>{real(vertex.position.x), real(vertex.position.y),
                                    realValue<Float>(vertex.channels[channel], channel)};
    };
    const std::array<Float, 3> p = point(vertices[0]);
    const std::array<Float, 3> q = point(vertices[1]);
    const std::array<Float, 3> r = point(vertices[2]);
    const auto cross = [&](std::size_t i, std::size_t j) {
        return (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
    };
    const Float a = cross(1, 2);
    const Float b = cross(2, 0);
    const Float c = cross(0, 1);
    return {a, b, c, -(a * p[0] + b * p[1] + c * p[2])};
}

template <std::same_as<CommonFraction> Exact, class Corner>
PlaneNormal<Exact> planeNormal(const std::array<Corner, 3> &vertices, std::size_t channel)
{
    const auto &[p, q, r] = vertices;
    constexpr Int128 unit = unitsPerPixel;
    const Int128 v0 = p.channels[channel];
    const Int128 v1 = q.channels[channel] - v0;
    const Int128 v2 = r.channels[channel] - v0;
    const Int128 x1 = q.position.x - p.position.x;
    const Int128 y1 = q.position.y - p.position.y;
    const Int128 x2 = r.position.x - p.position.x;
    const Int128 y2 = r.position.y - p.position.y;
    const Int128 a = y1 * v2 - v1 * y2;
    const Int128 b = v1 * x2 - x1 * v2;
    const Int128 c = x1 * y2 - y1 * x2;
    const Int128 d = -(a * p.position.x + b * p.position.y + c * v0);
    const Int128 units = unitsOfChannel(channel);
    return {{a, unit * units}, {b, unit * units}, {c, unit * unit}, {d, unit * unit * units}};
}

/// Whether every sample has the vertices' one colour, which floating numbers would round away.
template <class Number, std::size_t channelsInAll>
bool hasOneColour(const InterpolationSetUp<Number, channelsInAll> &setUp)
{
    if (!FloatingNumber<Number> || setUp.zeroArea)
        return false;
    const auto agree = [&vertices = setUp.vertices](std::size_t channel) {
        return vertices[0].channels[channel] == vertices[1].channels[channel]
            && vertices[0].channels[channel] == vertices[2].channels[channel];
    };
    return agree(0) && agree(1) && agree(2);
}

/// The plane (Scan Conversion slides, "2. Plane Equation"): v = −(A/C)·x − (B/C)·y − D/C.
template <class Integer, std::size_t channelsInAll>
void setPlane(InterpolationSetUp<FractionOf<Integer>, channelsInAll> &setUp, std::size_t channel)
{
    const auto &[p, q, r] = setUp.vertices;
    const Integer v0 = p.channels[channel];
    const Integer v1 = q.channels[channel] - v0;
    const Integer v2 = r.channels[channel] - v0;
    const Integer x1 = Integer(q.position.x) - p.position.x;
    const Integer y1 = Integer(q.position.y) - p.position.y;
    const Integer x2 = Integer(r.position.x) - p.position.x;
    const Integer y2 = Integer(r.position.y) - p.position.y;
    const Integer c = x1 * y2 - x2 * y1;
    const Integer sign = c < 0 ? -1 : 1;
    const Integer minusA = sign * (v1 * y2 - v2 * y1);
    const Integer minusB = sign * (v2 * x1 - v1 * x2);
    const Integer denominator = sign * c * unitsOfChannel(channel);
    setUp.plane[channel]
        = {FractionOf<Integer>{minusA * unitsPerPixel, denominator},
           FractionOf<Integer>{minusB * unitsPerPixel, denominator},
           FractionOf<Integer>{v0 * sign * c - minusA * p.position.x - minusB * p.position.y,
                               denominator}};
}

template <FloatingNumber Float, class Corner>
[[gnu::always_inline]] inline std::array<Float, 3> planeForm(const std::array<Corner, 3> &vertices,
                                                             std::size_t channel)
{
    const PlaneNormal<Float> normal = planeNormal<Float>(vertices, channel);
    return {-normal.a / normal.c, -normal.b / normal.c, -normal.d / normal.c};
}

template <FloatingNumber Float, std::size_t channelsInAll>
[[gnu::always_inline]] inline void setPlane(InterpolationSetUp<Float, channelsInAll> &setUp,
                                            std::size_t channel)
{
    if (hasOneColour(setUp) && channel < colourChannelCount) {
        setUp.plane[channel]
            = {0, 0, realValue<Float>(setUp.vertices[0].channels[channel], channel)};
    } else {
        setUp.plane[channel] = planeForm<Float>(setUp.vertices, channel);
    }
}

/// F(x, y) = A·x + B·y + C of the line that faces a vertex, in lattice units, and F at the vertex.
template <class Integer>
struct FacingLine {
    Integer a, b, c, there;

    template <class Corner>
    FacingLine(const std::array<Corner, 3> &vertices, std::size_t vertex)
    {
        const LatticePoint &at = vertices[vertex].position;
        const LatticePoint &from = vertices[(vertex + 1) % 3].position;
        const LatticePoint &to = vertices[(vertex + 2) % 3].position;
        a = Integer(to.y) - from.y;
        b = Integer(from.x) - to.x;
        c = -a * from.x - b * from.y;
        there = a * at.x + b * at.y + c;
    }
    Integer sign() const { return there < 0 ? -1 : 1; }
};

/// The weight of a vertex (Scan Conversion slides, "Computing Barycentric Coordinates"): the
/// equation F of the line through the other two, times the k that makes it 1 at the vertex.
template <class Integer, std::size_t channelsInAll>
void setWeight(InterpolationSetUp<FractionOf<Integer>, channelsInAll> &setUp, std::size_t vertex)
{
    const FacingLine<Integer> line(setUp.vertices, vertex);
    const Integer sign = line.sign();
    setUp.weight[vertex] = {FractionOf<Integer>{sign * line.a * unitsPerPixel, sign * line.there},
                            FractionOf<Integer>{sign * line.b * unitsPerPixel, sign * line.there},
                            FractionOf<Integer>{sign * line.c, sign * line.there}};
}

/// F(x, y) = A·x + B·y + C of the line that faces a vertex, and the k that makes it 1 there.
template <class Number>
struct ScaledLine {
    Number a, b, c, k;
};

template <FloatingNumber Float, class Corner>
ScaledLine<Float> scaledLine(const std::array<Corner, 3> &vertices, std::size_t vertex)
{
    const auto x = [&](std::size_t i) {
        return NumberTraits<Float>::fromLattice(vertices[i % 3].position.x);
    };
    const auto y = [&](std::size_t i) {
        return NumberTraits<Float>::fromLattice(vertices[i % 3].position.y);
    };
    const Float a = y(vertex + 2) - y(vertex + 1);
    const Float b = x(vertex + 1) - x(vertex + 2);
    const Float c = -a * x(vertex + 1) - b * y(vertex + 1);
    return {a, b, c, Float(1) / (a * x(vertex) + b * y(vertex) + c)};
}

template <std::same_as<CommonFraction> Exact, class Corner>
ScaledLine<Exact> scaledLine(const std::array<Corner, 3> &vertices, std::size_t vertex)
{
    constexpr Int128 unit = unitsPerPixel;
    const FacingLine<Int128> line(vertices, vertex);
    return {{line.a, unit},
            {line.b, unit},
            {line.c, unit * unit},
            {line.sign() * unit * unit, line.sign() * line.there}};
}

template <FloatingNumber Float, class Corner>
std::array<Float, 3> weightForm(const std::array<Corner, 3> &vertices, std::size_t vertex)
{
    const ScaledLine<Float> line = scaledLine<Float>(vertices, vertex);
    return {line.k * line.a, line.k * line.b, line.k * line.c};
}

template <FloatingNumber Float, std::size_t channelsInAll>
void setWeight(InterpolationSetUp<Float, channelsInAll> &setUp, std::size_t vertex)
{
    setUp.weight[vertex] = weightForm<Float>(setUp.vertices, vertex);
}

/// The channel values of a vertex, to be weighted.
template <class Number, std::size_t channelsInAll>
void setWeighted(InterpolationSetUp<Number, channelsInAll> &setUp, std::size_t vertex)
{
    for (std::size_t channel = 0; channel < setUp.carried(); ++channel)
        setUp.weighted[channel][vertex]
            = VertexValue<Number>::of(setUp.vertices[vertex].channels[channel], channel);
}

/// α·v0 + β·v1 + γ·v2; the exact weights share their denominator, the doubled area.
template <class Integer>
FractionOf<Integer> weightedSum(const std::array<FractionOf<Integer>, 3> &weight,
                                const std::array<std::int64_t, 3> &value, std::size_t channel)
{
    FractionOf<Integer> sum{0, weight[0].denominator * unitsOfChannel(channel)};
    for (std::size_t i = 0; i < 3; ++i)
        sum.numerator += weight[i].numerator * value[i];
    return sum;
}

template <FloatingNumber Float>
Float weightedSum(const std::array<Float, 3> &weight, const std::array<Float, 3> &value,
                  std::size_t)
{
    return weight[0] * value[0] + weight[1] * value[1] + weight[2] * value[2];
}

} // namespace pixelplumb
