// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/countednumber.h"
#include "core/scan/constantratearithmetic.h"
#include "core/scan/curves/circleexplicit.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/interpolation/interpolationnumbers.h"
#include "core/scan/lines/lineslopeintercept.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/tests/planearithmetic.h"

/// The arithmetics of the walks in counting numbers.
namespace pixelplumb {

/// One conversion turns a coordinate into a number, scaling by a power of two included. One
/// rounding includes taking the integer.
template <class T>
struct NumberTraits<Counted<T>> {
    using Plain = NumberTraits<T>;
    static constexpr Arithmetic arithmetic = Plain::arithmetic;

    static bool represents(Lattice units) { return Plain::represents(units); }
    static Counted<T> fromInteger(std::int64_t integer)
    {
        OperationTally::count(Operation::Conversion);
        return Plain::fromInteger(integer);
    }
    static Counted<T> fromLattice(Lattice units)
    {
        OperationTally::count(Operation::Conversion);
        return Plain::fromLattice(units);
    }
    static std::int64_t floor(const Counted<T> &value)
    {
        OperationTally::count(Operation::Rounding);
        return Plain::floor(value.plain());
    }
    static std::int64_t ceil(const Counted<T> &value)
    {
        OperationTally::count(Operation::Rounding);
        return Plain::ceil(value.plain());
    }
};

/// The increments in a number that rounds.
template <class T>
struct CountedRounded : RoundedArithmetic<Counted<T>> {
    using Base = RoundedArithmetic<Counted<T>>;
    using typename Base::Number;

    static Number edgeColourRate(const Vertex &a, const Vertex &b, std::size_t channel)
    {
        if (a.position.x != b.position.x)
            OperationTally::count(Operation::IntegerAddition); // of the two levels
        return Base::edgeColourRate(a, b, channel);
    }
    /// Counts one rounding, which includes adding the half for the nearest level.
    static std::int64_t level(const Number &number, ByteRounding rounding)
    {
        OperationTally::count(Operation::Rounding);
        return RoundedArithmetic<T>::level(number.plain(), rounding);
    }
};

/// Quotients and remainders: the plain code in counting integers.
using CountedExact = ExactArithmetic<Counted<Int128>>;

/// A fixed-point quotient is rounded to nearest within the division.
template <class T>
struct RoundedFraction<Counted<T>> {
    static Counted<T> of(const Counted<Int128> &numerator, const Counted<Int128> &denominator)
    {
        OperationTally::count(Operation::Conversion, std::floating_point<T> ? 2 : 0);
        OperationTally::count(Operation::Division);
        return RoundedFraction<T>::of(numerator.plain(), denominator.plain());
    }
};

template <class T>
struct LineEquation<CountedRounded<T>> : LineEquation<RoundedArithmetic<Counted<T>>> {
    /// (int)(y + 1/2) counts as one rounding.
    static std::int64_t rounded(const Counted<T> &y)
    {
        OperationTally::count(Operation::Rounding);
        return LineEquation<RoundedArithmetic<T>>::rounded(y.plain());
    }
};

template <class T>
struct ExplicitRoot<CountedRounded<T>> : ExplicitRoot<RoundedArithmetic<Counted<T>>> {
};

/// Integers: the plain code in counting integers.
using CountedExactPlane = ExactPlane<Counted<Int128>>;

/// In a number that rounds: a length is one conversion, its scaling by a power of two included.
template <std::floating_point Float>
struct CountedFloatPlane {
    using Plain = FloatPlane<Float>;
    using Number = Counted<Float>;
    using Ratio = Counted<Float>;
    static constexpr Arithmetic arithmetic = Plain::arithmetic;

    /// A vertex's level is converted to a float once.
    class Level : public Number {
    public:
        Level() = default;
        explicit Level(int level)
            : Number(Float(level))
        {
            OperationTally::count(Operation::Conversion);
        }
    };

    static Number length(Lattice units)
    {
        OperationTally::count(Operation::Conversion);
        return Plain::length(units);
    }
    static Number distance(Lattice from, Lattice to)
    {
        OperationTally::count(Operation::IntegerAddition);
        return length(to - from);
    }
    using Divisor = Number;
    static Ratio ratio(const Number &a, const Divisor &b) { return a / b; }
    static bool isInside(const Number &number, bool ownsTie)
    {
        OperationTally::count(Operation::Comparison);
        return Plain::isInside(number.plain(), ownsTie);
    }
    static Ratio fraction(Int128 numerator, Int128 denominator)
    {
        OperationTally::count(Operation::Conversion, 2);
        OperationTally::count(Operation::Division);
        return Plain::fraction(numerator, denominator);
    }
    static std::int64_t level(const Ratio &level, ByteRounding rounding)
    {
        OperationTally::count(Operation::Rounding);
        return Plain::level(level.plain(), rounding);
    }
};

template <std::floating_point Float>
std::int64_t levelOf(const Counted<Float> &value, ByteRounding rounding)
{
    OperationTally::count(Operation::Rounding);
    return levelOf(value.plain(), rounding);
}

} // namespace pixelplumb
