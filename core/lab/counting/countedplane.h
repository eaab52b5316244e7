// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/countednumber.h"
#include "core/scan/interpolation/interpolationnumbers.h"
#include "core/scan/tests/planearithmetic.h"

/// The arithmetics of edge functions, weights and channels in counting numbers.
namespace pixelplumb {

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
