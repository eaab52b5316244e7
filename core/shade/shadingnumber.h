// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"
#include "core/number/widerinteger.h"
#include "core/scan/roundedarithmetic.h"
#include "core/shade/channel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// The numbers of shaded kernels: exact integers over a common denominator, or floating point. Both
/// define how vertex values become a channel's value at a sample, and how that becomes bytes,
/// depths and texels.
namespace pixelplumb {

/// Numerators over the triangle's doubled area or, with perspective correction, over the numerator
/// of 1/w: a value is the quotient of two linear forms of integers. Integer is Int128 where
/// fitsNarrowShading() allows it, else Int256.
template <class Int>
struct ExactShading {
    using Integer = Int;
    using Number = Integer; ///< the numerator of a channel
    using Real = double; ///< for values without an exact form: unit vectors, powers
    static constexpr bool isExact = true;
    /// Holds the doubled area.
    using Narrow = std::conditional_t<std::is_same_v<Integer, Int128>, std::int64_t, Int128>;

    /// A depth: ⌊z·2^24⌋ and the remainder over the doubled area.
    struct Depth {
        std::int64_t whole = std::numeric_limits<std::int64_t>::max();
        Narrow rest = 0;
        Narrow denominator = 1;

        friend bool operator<=(const Depth &a, const Depth &b)
        {
            using Wider = TwiceAsWide<Narrow>;
            if (a.whole != b.whole)
                return a.whole < b.whole;
            return Wider(a.rest) * b.denominator <= Wider(b.rest) * a.denominator;
        }
    };

    /// numerator/denominator, rounded by the settings.
    static std::int64_t level(const Number &numerator, const Number &denominator,
                              ByteRounding rounding)
    {
        if (rounding == ByteRounding::Truncate)
            return std::int64_t(floorDivide<Number>(numerator, denominator));
        return std::int64_t(
            floorDivide<Number>(2 * numerator + denominator, Number(2 * denominator)));
    }
    static Depth depth(const Number &numerator, const Number &area)
    {
        const Number whole = floorDivide<Number>(numerator, area);
        return {std::int64_t(whole), Narrow(numerator - whole * area), Narrow(area)};
    }
    /// ⌊z·most + ½⌋ with z clamped to 0 … 1.
    static std::uint32_t depthLevel(const Number &numerator, const Number &area, std::uint32_t most)
    {
        const Number one = area * attributeOne;
        if (numerator <= 0)
            return 0;
        if (numerator >= one)
            return most;
        return std::uint32_t(
            floorDivide<Number>(2 * numerator * Number(most) + one, Number(2 * one)));
    }
    static Real real(const Number &numerator, const Number &denominator)
    {
        return Real(numerator) / Real(denominator);
    }
};

template <std::floating_point Float>
struct FloatShading {
    using Number = Float;
    using Real = Float;
    using Depth = Float;
    static constexpr bool isExact = false;

    static std::int64_t level(Number value, ByteRounding rounding)
    {
        return RoundedArithmetic<Float>::level(value, rounding);
    }
    static std::uint32_t depthLevel(Number z, std::uint32_t most)
    {
        // A product with 2^32 − 1 would round in float32, so the levels are computed in double.
        const double level = std::clamp(double(z), 0.0, 1.0) * most + 0.5;
        return level > 0 ? std::uint32_t(std::int64_t(level)) : 0; // 0 for NaN
    }
};

} // namespace pixelplumb
