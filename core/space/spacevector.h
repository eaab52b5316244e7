// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/camera.h"

#include <cmath>
#include <utility>

namespace pixelplumb {

/// A point or direction in space. Drawing uses double; a wider number type gives the result without
/// rounding.
template <class Number>
struct SpaceVector {
    Number x = Number(0);
    Number y = Number(0);
    Number z = Number(0);

    SpaceVector() = default;
    SpaceVector(Number atX, Number atY, Number atZ)
        : x(std::move(atX))
        , y(std::move(atY))
        , z(std::move(atZ))
    {
    }
    explicit SpaceVector(const Vector3 &vector)
        : SpaceVector(Number(vector[0]), Number(vector[1]), Number(vector[2]))
    {
    }

    bool isZero() const { return x == 0 && y == 0 && z == 0; }

    friend SpaceVector operator+(const SpaceVector &a, const SpaceVector &b)
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend SpaceVector operator-(const SpaceVector &a, const SpaceVector &b)
    {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend SpaceVector operator*(const Number &factor, const SpaceVector &a)
    {
        return {factor * a.x, factor * a.y, factor * a.z};
    }
    friend bool operator==(const SpaceVector &, const SpaceVector &) = default;
};

template <class Number>
Number dot(const SpaceVector<Number> &a, const SpaceVector<Number> &b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
SpaceVector<Number> cross(const SpaceVector<Number> &a, const SpaceVector<Number> &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Number>
Number lengthOf(const SpaceVector<Number> &a)
{
    using std::sqrt;
    return sqrt(dot(a, a));
}

/// The normalized vector; 0 for a vector without length.
template <class Number>
SpaceVector<Number> unit(const SpaceVector<Number> &a)
{
    const Number length = lengthOf(a);
    if (length == 0)
        return {};
    return {a.x / length, a.y / length, a.z / length};
}

/// a + t(b − a).
template <class Number>
Number between(const Number &a, const Number &b, const Number &t)
{
    return a + t * (b - a);
}

template <class Number>
SpaceVector<Number> between(const SpaceVector<Number> &a, const SpaceVector<Number> &b,
                            const Number &t)
{
    return a + t * (b - a);
}

} // namespace pixelplumb
