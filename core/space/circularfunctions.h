// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace pixelplumb {

/// The point at some angle on the unit circle.
template <class Number>
struct CirclePoint {
    Number cosine = Number(1);
    Number sine = Number(0);
};

/// The point at part/whole of a full turn; exact at quarter turns, so that poles and seams meet.
template <class Number>
CirclePoint<Number> circlePoint(const Number &part, const Number &whole)
{
    using std::acos;
    using std::cos;
    using std::floor;
    using std::sin;
    const Number quarters = 4 * part / whole;
    const Number first = floor(quarters);
    const Number rest = quarters - first;
    CirclePoint<Number> point;
    if (rest != 0) {
        const Number angle = rest * acos(Number(0));
        point = {cos(angle), sin(angle)};
    }
    const Number turned = first - 4 * floor(first / 4);
    if (turned == 1)
        return {-point.sine, point.cosine};
    if (turned == 2)
        return {-point.cosine, -point.sine};
    if (turned == 3)
        return {point.sine, -point.cosine};
    return point;
}

} // namespace pixelplumb
