// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/number/fixedpoint.h"
#include "core/number/three.h"
#include "core/number/wholenumber.h"
#include "core/scan/scansettings.h"

#include <concepts>

namespace pixelplumb {

/// How each rounding number is made from the lattice's integers and read back.
template <class Value>
struct NumberTraits;

template <std::floating_point Float>
struct NumberTraits<Float> {
    static constexpr Arithmetic arithmetic
        = sizeof(Float) == sizeof(float) ? Arithmetic::Float32 : Arithmetic::Float64;
    static bool represents(Lattice) { return true; }
    static Float fromInteger(std::int64_t integer) { return Float(integer); }
    static Float fromLattice(Lattice units) { return Float(units) / Float(unitsPerPixel); }
    static std::int64_t floor(Float value) { return floorOf(value); }
    static std::int64_t ceil(Float value) { return ceilOf(value); }
};

template <class Raw, class Product, int FractionBits>
struct NumberTraits<FixedPoint<Raw, Product, FractionBits>> {
    using Fixed = FixedPoint<Raw, Product, FractionBits>;
    static constexpr Arithmetic arithmetic
        = FractionBits == 16 ? Arithmetic::Fixed16 : Arithmetic::Fixed32;

    /// Tests the coordinate itself; what is computed from it may still wrap.
    static bool represents(Lattice units)
    {
        constexpr int integerBits = int(8 * sizeof(Raw)) - 1 - FractionBits;
        return absolute(units) < (Lattice(1) << integerBits) * unitsPerPixel;
    }
    static Fixed fromInteger(std::int64_t integer) { return Fixed::fromInteger(integer); }
    static Fixed fromLattice(Lattice units)
    {
        return Fixed::fromBinaryFraction(units, unitsPerPixel);
    }
    static std::int64_t floor(Fixed value) { return value.floor(); }
    static std::int64_t ceil(Fixed value) { return value.ceil(); }
};

/// The assignment's increments taken literally in a number that rounds: slope and colour rates are
/// precomputed quotients, which each column adds, ΔR = (R_T − R_B)/(y_T − y_B), and R starts at R_B
/// + (⌈y_B⌉ − y_B)·ΔR.
template <class Value>
struct RoundedArithmetic {
    using Number = Value;
    using Traits = NumberTraits<Value>;
    static constexpr Arithmetic arithmetic = Traits::arithmetic;
    static constexpr bool boundsMayCross = true;

    static bool represents(const LatticePoint &point)
    {
        return Traits::represents(point.x) && Traits::represents(point.y);
    }

    [[gnu::always_inline]] static Number edgeSlope(const Vertex &a, const Vertex &b)
    {
        if (a.position.x == b.position.x)
            return Traits::fromInteger(0);
        return (Traits::fromLattice(b.position.y) - Traits::fromLattice(a.position.y))
            / (Traits::fromLattice(b.position.x) - Traits::fromLattice(a.position.x));
    }
    /// The pre-step from a vertex to a column.
    static Number runTo(std::int64_t column, const Vertex &a)
    {
        return Traits::fromInteger(column) - Traits::fromLattice(a.position.x);
    }
    /// y at a column: the vertex plus the pre-step.
    static Number edgeOrdinate(const Vertex &a, const Vertex &, const Number &run,
                               const Number &slope)
    {
        return Traits::fromLattice(a.position.y) + run * slope;
    }
    [[gnu::always_inline]] static Number edgeColourRate(const Vertex &a, const Vertex &b,
                                                        std::size_t channel)
    {
        if (a.position.x == b.position.x)
            return Traits::fromInteger(0);
        return Traits::fromInteger(b.colour.channels[channel] - a.colour.channels[channel])
            / (Traits::fromLattice(b.position.x) - Traits::fromLattice(a.position.x));
    }
    static Number edgeColour(const Vertex &a, const Vertex &, std::size_t channel,
                             const Number &run, const Number &rate)
    {
        return Traits::fromInteger(a.colour.channels[channel]) + run * rate;
    }

    static std::int64_t floor(Number number) { return Traits::floor(number); }
    static std::int64_t ceil(Number number) { return Traits::ceil(number); }
    static void advance(Number &number, Number rate) { number = number + rate; }

    static std::int64_t level(Number number, ByteRounding rounding)
    {
        if (rounding == ByteRounding::Truncate)
            return Traits::floor(number);
        return Traits::floor(number + Traits::fromInteger(1) / Traits::fromInteger(2));
    }

    class ColourRamp {
    public:
        /// Whether a triangle that has area needs its edges' colours.
        static constexpr bool readsEdges = true;

        ColourRamp(const Vertex &, const Vertex &, const Vertex &) { }

        /// 0 where y_B = y_T: such a column has at most one sample and no change to spread.
        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> rates(const ColumnState &column) const
        {
            if (column.yTop == column.yBottom) {
                const Number none = Traits::fromInteger(0);
                return {none, none, none};
            }
            const Number height = column.yTop - column.yBottom;
            return threeOf([&](std::size_t channel) {
                return (column.colourTop[channel] - column.colourBottom[channel]) / height;
            });
        }
        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> starts(const ColumnState &column,
                                                            std::int64_t row) const
        {
            const Number up = Traits::fromInteger(row) - column.yBottom;
            return threeOf([&](std::size_t channel) {
                return column.colourBottom[channel] + up * column.colourRate[channel];
            });
        }
    };
};

} // namespace pixelplumb
