// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/number/quantity.h"
#include "core/scan/scansettings.h"

#include <cmath>
#include <concepts>

namespace pixelplumb {

/// A fraction that meets only integers and fractions of its own denominator, so that adding needs
/// no common multiple: all weights of a triangle have its doubled area below.
struct CommonFraction {
    Int128 numerator = 0;
    Int128 denominator = 1; ///< > 0

    friend constexpr CommonFraction operator+(CommonFraction a, const CommonFraction &b)
    {
        return {a.numerator + b.numerator, a.denominator};
    }
    friend constexpr CommonFraction operator-(CommonFraction a, const CommonFraction &b)
    {
        return {a.numerator - b.numerator, a.denominator};
    }
    friend constexpr CommonFraction operator-(int whole, const CommonFraction &a)
    {
        return {whole * a.denominator - a.numerator, a.denominator};
    }
    friend constexpr CommonFraction operator*(CommonFraction a, int factor)
    {
        return {a.numerator * factor, a.denominator};
    }
    friend constexpr bool operator==(const CommonFraction &a, int whole)
    {
        return a.numerator == whole * a.denominator;
    }
    friend constexpr auto operator<=>(const CommonFraction &a, int whole)
    {
        return a.numerator <=> whole * a.denominator;
    }
};

/// Edge functions and weights in integers: lengths in lattice units, products in square lattice
/// units, |product| < 2^80; ratios are fractions. Nothing is rounded.
struct ExactPlane {
    using Number = Int128;
    using Ratio = CommonFraction;
    static constexpr Arithmetic arithmetic = Arithmetic::Exact;

    static constexpr Number length(Lattice units) { return units; }
    /// The divisor of a triangle without area is 0 and never used; it must only not trap.
    static constexpr Ratio ratio(Number a, Number b)
    {
        if (b == 0)
            return {0, 1};
        return b < 0 ? Ratio{-a, -b} : Ratio{a, b};
    }
    static constexpr Ratio fraction(Int128 numerator, Int128 denominator)
    {
        return {numerator, denominator};
    }
    static std::int64_t level(const Ratio &level, ByteRounding rounding)
    {
        if (rounding == ByteRounding::Truncate)
            return std::int64_t(floorDivide(level.numerator, level.denominator));
        return std::int64_t(
            floorDivide(2 * level.numerator + level.denominator, 2 * level.denominator));
    }

    /// What a number stands for, by what stands for 1; and a change for each step of a pixel.
    static Quantity quantityOf(Number number, Int128 unit)
    {
        return Quantity::rational(number, unit);
    }
    static Quantity quantityOfRate(Number number, Int128 unit)
    {
        return Quantity::rational(number * unitsPerPixel, unit);
    }
    static Quantity quantityOf(const Ratio &ratio)
    {
        return Quantity::rational(ratio.numerator, ratio.denominator);
    }
};

/// The same in pixels, in a number that rounds.
template <std::floating_point Float>
struct FloatPlane {
    using Number = Float;
    using Ratio = Float;
    static constexpr Arithmetic arithmetic
        = sizeof(Float) == sizeof(float) ? Arithmetic::Float32 : Arithmetic::Float64;

    static Number length(Lattice units) { return Float(units) / Float(unitsPerPixel); }
    static Ratio ratio(Number a, Number b) { return a / b; }
    static Ratio fraction(Int128 numerator, Int128 denominator)
    {
        return Float(numerator) / Float(denominator);
    }
    /// NaN counts as far below: a byte of 0.
    static std::int64_t level(Ratio level, ByteRounding rounding)
    {
        constexpr auto limit = Float(std::int64_t(1) << 40);
        const Float floor
            = std::floor(rounding == ByteRounding::Nearest ? level + Float(0.5) : level);
        if (!(floor > -limit))
            return -(std::int64_t(1) << 40);
        return floor < limit ? std::int64_t(floor) : std::int64_t(1) << 40;
    }

    static Quantity quantityOf(Number number, Int128) { return Quantity::of(number); }
    static Quantity quantityOfRate(Number number, Int128) { return Quantity::of(number); }
    static Quantity quantityOf(Ratio ratio) { return Quantity::of(ratio); }
};

} // namespace pixelplumb
