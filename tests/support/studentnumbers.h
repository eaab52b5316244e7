// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>

/// The numbers a student's program computes in (fractions or doubles), and its vertices and edges
/// in them.
namespace pixelplumb::studentloops {

using Fraction = boost::multiprecision::cpp_rational;
using Whole = boost::multiprecision::cpp_int;

inline int floorOf(double number) { return int(std::clamp(std::floor(number), -1e9, 1e9)); }

inline int floorOf(const Fraction &number)
{
    const Whole below = numerator(number) / denominator(number);
    return int(below) - (number < Fraction(below) ? 1 : 0);
}

template <class Number>
int ceilOf(const Number &number)
{
    return -floorOf(Number(-number));
}

template <class Number>
int nearestOf(const Number &number)
{
    return floorOf(Number(number + Number(1) / 2));
}

/// An (int) cast.
template <class Number>
Number cast(const Number &number)
{
    return Number(number < 0 ? ceilOf(number) : floorOf(number));
}

template <class Number>
struct Corner {
    Number x, y;
    std::array<Number, 3> colour;
};

/// Where an edge meets a span, and the increments from span to span.
template <class Number>
struct Bound {
    Number y, slope = 0;
    std::array<Number, 3> colour, step = {};
};

} // namespace pixelplumb::studentloops
