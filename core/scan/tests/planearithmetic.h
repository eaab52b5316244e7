// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/number/commonfraction.h"
#include "core/number/quantity.h"
#include "core/number/wholenumber.h"
#include "core/scan/scansettings.h"

#include <concepts>

namespace pixelplumb {

/// Edge functions and weights in integers: lengths in lattice units, products in square lattice
/// units; ratios are fractions. Nothing is rounded. In Int128, |product| < 2^80. In std::int64_t,
/// where triangle, samples and off-screen point lie within 2^15 px (isNarrow()), values stay below
/// 2^50 and twice a sum of three of them times levels below 2^60.
template <class Integer>
struct ExactPlane {
    using Number = Integer;
    using Ratio = FractionOf<Integer>;
    using Level = int; ///< of a vertex
    static constexpr Arithmetic arithmetic = Arithmetic::Exact;

    static constexpr Number length(Lattice units) { return units; }
    static constexpr Number distance(Lattice from, Lattice to)
    {
        return NarrowBeside<Integer>(to) - from;
    }
    /// A divisor other than 0.
    struct Divisor {
        Number sign;
        Number size; ///< > 0

        constexpr explicit Divisor(const Number &number)
            : sign(number < 0 ? -1 : 1)
            , size(sign * number)
        {
        }
    };
    static constexpr Ratio ratio(const Number &a, const Divisor &b) { return {a * b.sign, b.size}; }
    /// Tests a sample's value or weight; 0 is inside if its tie is owned.
    static constexpr bool isInside(const Number &number, bool ownsTie)
    {
        return number >= Number(ownsTie ? 0 : 1);
    }
    static constexpr bool isInside(const Ratio &ratio, bool ownsTie)
    {
        return isInside(ratio.numerator, ownsTie);
    }
    static constexpr Ratio fraction(Int128 numerator, Int128 denominator)
    {
        return {Integer(numerator), Integer(denominator)};
    }
    static std::int64_t level(const Ratio &level, ByteRounding rounding)
    {
        return std::int64_t(rounding == ByteRounding::Truncate ? level.floor() : level.nearest());
    }

    /// A number as a quantity, given what stands for 1; and a change per pixel as one.
    static Quantity quantityOf(Number number, Int128 unit)
    {
        return Quantity::rational(number, unit);
    }
    static Quantity quantityOfRate(Number number, Int128 unit)
    {
        return Quantity::rational(Int128(number) * unitsPerPixel, unit);
    }
    static Quantity quantityOf(const Ratio &ratio)
    {
        return Quantity::rational(ratio.numerator, ratio.denominator);
    }
};

/// Edge functions and weights in pixels, in a number that rounds.
template <std::floating_point Float>
struct FloatPlane {
    using Number = Float;
    using Ratio = Float;
    using Level = Float;
    static constexpr Arithmetic arithmetic
        = sizeof(Float) == sizeof(float) ? Arithmetic::Float32 : Arithmetic::Float64;

    static Number length(Lattice units) { return Float(units) / Float(unitsPerPixel); }
    /// Subtracts on the lattice, where nothing rounds.
    static Number distance(Lattice from, Lattice to) { return length(to - from); }
    using Divisor = Float;
    static Ratio ratio(Number a, Divisor b) { return a / b; }
    static bool isInside(Number number, bool ownsTie)
    {
        if (!(number >= Float(0)))
            return false;
        if (ownsTie) [[likely]]
            return true;
        return number > Float(0);
    }
    static Ratio fraction(Int128 numerator, Int128 denominator)
    {
        return Float(numerator) / Float(denominator);
    }
    /// NaN counts as far below: a byte of 0.
    static std::int64_t level(Ratio level, ByteRounding rounding)
    {
        return floorOf(rounding == ByteRounding::Nearest ? level + Float(0.5) : level);
    }

    static Quantity quantityOf(Number number, Int128) { return Quantity::of(number); }
    static Quantity quantityOfRate(Number number, Int128) { return Quantity::of(number); }
    static Quantity quantityOf(Ratio ratio) { return Quantity::of(ratio); }
};

} // namespace pixelplumb
