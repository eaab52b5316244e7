// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/interpolationnumbers.h"

namespace pixelplumb {

/// a·x + b·y + c at a sample.
inline Ratio linearAt(const std::array<Ratio, 3> &form, std::int64_t x, std::int64_t y)
{
    return {form[0].numerator * x + form[1].numerator * y + form[2].numerator, form[0].denominator};
}

template <std::floating_point Float>
Float linearAt(const std::array<Float, 3> &form, std::int64_t x, std::int64_t y)
{
    return form[0] * Float(x) + form[1] * Float(y) + form[2];
}

/// The plane through the three values of a channel (seed 003, "Plane Equation"): with the normal
/// ⟨A, B, C⟩ = (P1 − P0) × (P2 − P0) and D = −N·P0, v = −(A/C)·x − (B/C)·y − D/C.
inline void setPlane(InterpolationSetUp<Ratio> &setUp, std::size_t channel)
{
    const auto &[p, q, r] = setUp.vertices;
    const Int128 v0 = p.channels[channel];
    const Int128 v1 = q.channels[channel] - v0;
    const Int128 v2 = r.channels[channel] - v0;
    const Int128 x1 = q.position.x - p.position.x;
    const Int128 y1 = q.position.y - p.position.y;
    const Int128 x2 = r.position.x - p.position.x;
    const Int128 y2 = r.position.y - p.position.y;
    const Int128 c = x1 * y2 - x2 * y1;
    const Int128 sign = c < 0 ? -1 : 1;
    const Int128 minusA = sign * (v1 * y2 - v2 * y1);
    const Int128 minusB = sign * (v2 * x1 - v1 * x2);
    const Int128 denominator = sign * c * unitsPerPixel;
    setUp.plane[channel]
        = {Ratio{minusA * unitsPerPixel, denominator}, Ratio{minusB * unitsPerPixel, denominator},
           Ratio{v0 * sign * c - minusA * p.position.x - minusB * p.position.y, denominator}};
}

template <std::floating_point Float>
void setPlane(InterpolationSetUp<Float> &setUp, std::size_t channel)
{
    const auto real = [](Lattice units) { return NumberTraits<Float>::fromLattice(units); };
    const auto point = [&](const ChannelVertex &vertex) {
        return std::array<Float, 3>{real(vertex.position.x), real(vertex.position.y),
                                    real(vertex.channels[channel])};
    };
    const std::array<Float, 3> p = point(setUp.vertices[0]);
    const std::array<Float, 3> q = point(setUp.vertices[1]);
    const std::array<Float, 3> r = point(setUp.vertices[2]);
    const auto cross = [&](std::size_t i, std::size_t j) {
        return (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
    };
    const Float a = cross(1, 2);
    const Float b = cross(2, 0);
    const Float c = cross(0, 1);
    const Float d = -(a * p[0] + b * p[1] + c * p[2]);
    setUp.plane[channel] = {-a / c, -b / c, -d / c};
}

/// The weight of a vertex (seed 003, "Computing Barycentric Coordinates"): the equation F of the
/// line through the other two, times the k that makes it 1 at the vertex.
inline void setWeight(InterpolationSetUp<Ratio> &setUp, std::size_t vertex)
{
    const LatticePoint &at = setUp.vertices[vertex].position;
    const LatticePoint &from = setUp.vertices[(vertex + 1) % 3].position;
    const LatticePoint &to = setUp.vertices[(vertex + 2) % 3].position;
    const Int128 a = to.y - from.y;
    const Int128 b = from.x - to.x;
    const Int128 c = -a * from.x - b * from.y;
    const Int128 there = a * at.x + b * at.y + c;
    const Int128 sign = there < 0 ? -1 : 1;
    setUp.weight[vertex]
        = {Ratio{sign * a * unitsPerPixel, sign * there},
           Ratio{sign * b * unitsPerPixel, sign * there}, Ratio{sign * c, sign * there}};
}

template <std::floating_point Float>
void setWeight(InterpolationSetUp<Float> &setUp, std::size_t vertex)
{
    const auto x = [&](std::size_t i) {
        return NumberTraits<Float>::fromLattice(setUp.vertices[i % 3].position.x);
    };
    const auto y = [&](std::size_t i) {
        return NumberTraits<Float>::fromLattice(setUp.vertices[i % 3].position.y);
    };
    const Float a = y(vertex + 2) - y(vertex + 1);
    const Float b = x(vertex + 1) - x(vertex + 2);
    const Float c = -a * x(vertex + 1) - b * y(vertex + 1);
    const Float k = Float(1) / (a * x(vertex) + b * y(vertex) + c);
    setUp.weight[vertex] = {k * a, k * b, k * c};
}

/// α·v0 + β·v1 + γ·v2; the exact weights share their denominator, the doubled area.
inline Ratio weighted(const std::array<Ratio, 3> &weight, const std::array<Lattice, 3> &value)
{
    Ratio sum{0, weight[0].denominator * unitsPerPixel};
    for (std::size_t i = 0; i < 3; ++i)
        sum.numerator += weight[i].numerator * value[i];
    return sum;
}

template <std::floating_point Float>
Float weighted(const std::array<Float, 3> &weight, const std::array<Lattice, 3> &value)
{
    const auto real = [](Lattice units) { return NumberTraits<Float>::fromLattice(units); };
    return weight[0] * real(value[0]) + weight[1] * real(value[1]) + weight[2] * real(value[2]);
}

} // namespace pixelplumb
