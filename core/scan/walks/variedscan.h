// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/columnstate.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/roundedarithmetic.h"

#include <algorithm>

/// How the column scan is given departures (scansettings.h): none, which costs nothing, or a set of
/// them.
namespace pixelplumb {

/// The correct column scan.
struct RightScan {
    template <class A>
    using Ramp = typename A::ColourRamp;
    /// Whether rounding can take the two bounds of a column past each other.
    template <class A>
    static constexpr bool boundsMayCross = A::boundsMayCross;

    struct Edge {
        const Vertex &a;
        const Vertex &b;
    };

    template <class A>
    static bool represents(const LatticePoint &point)
    {
        return A::represents(point);
    }
    /// The edge from a to b as it is walked.
    static constexpr Edge edge(const Vertex &a, const Vertex &b) { return {a, b}; }
    template <class Number>
    static bool isBelow(const Number &a, const Number &b)
    {
        return a < b;
    }
    /// R G B at the column's first drawn row.
    template <class AnyRamp, class Column>
    [[gnu::always_inline]] static auto starts(const AnyRamp &ramp, const Column &column)
    {
        return ramp.starts(column, column.firstDrawn);
    }
};

/// R of a column as the assignment literally has it, ΔR = (R_T − R_B)/(y_T − y_B) and R_B + (row −
/// y_B)·ΔR, whatever the bounds and colours: departures have no plane through the three vertices.
template <class A>
class LiteralRamp : public A::ColourRamp {
    using Base = typename A::ColourRamp;
    using Number = typename A::Number;

public:
    using Base::Base;

    static bool represents(const LatticePoint &) { return true; }
    static Number wholeRow(std::int64_t row) { return NumberTraits<Number>::fromInteger(row); }

    /// R G B at a row, if the lower bound's colours hold at `from`, px.
    template <class Column>
    std::array<Number, 3> startsFrom(const Number &from, const Column &column,
                                     std::int64_t row) const
    {
        const Number up = wholeRow(row) - from;
        return threeOf([&](std::size_t channel) {
            return column.colourBottom[channel] + up * column.colourRate[channel];
        });
    }
};

/// LiteralRamp in integers, for coordinates of up to 2^15 px. A bound is y = Y/(d·S) with the
/// colour c/d there, so that ΔR = (c_T·d_B − c_B·d_T)·S/h with h = Y_T·d_B − Y_B·d_T. Written over
/// d_B·h, like R, it is added without division. |h| < 2^80 and d < 2^25.
template <>
class LiteralRamp<ExactArithmetic<Int128>> {
    using Number = MixedNumber<Int128>;

public:
    static constexpr bool readsEdges = true;

    LiteralRamp(const Vertex &, const Vertex &, const Vertex &) { }

    static bool represents(const LatticePoint &point) { return isNarrow(point); }
    static Number wholeRow(std::int64_t row) { return Number::fromWhole(row); }

    /// 0 where y_B = y_T: such a column has at most one sample and no change to spread.
    template <class Column>
    std::array<Number, 3> rates(const Column &column) const
    {
        return threeOf([&](std::size_t channel) {
            const Int128 height = heightOf(column, channel);
            const Int128 own = column.colourBottom[channel].denominator;
            if (height == 0)
                return Number::fromFraction(0, own);
            const Int128 rise = riseOf(column, channel) * unitsPerPixel * own;
            return Number::fromFraction(height < 0 ? -rise : rise, absolute(height) * own);
        });
    }
    template <class Column>
    std::array<Number, 3> startsFrom(const Number &from, const Column &column,
                                     std::int64_t row) const
    {
        return threeOf([&](std::size_t channel) {
            const Int128 height = heightOf(column, channel);
            const Number &lower = column.colourBottom[channel];
            if (height == 0)
                return lower;
            // (row − from)·S·d_B is whole: from is a row or the lower bound itself.
            const Int128 up = (row * from.denominator - numerator(from)) * unitsPerPixel
                * lower.denominator / from.denominator;
            const Int128 change = up * riseOf(column, channel);
            return Number::fromFraction(numerator(lower) * absolute(height)
                                            + (height < 0 ? -change : change),
                                        absolute(height) * lower.denominator);
        });
    }

private:
    static Int128 numerator(const Number &number)
    {
        return Int128(number.whole) * number.denominator + number.remainder;
    }
    template <class Column>
    static Int128 riseOf(const Column &column, std::size_t channel)
    {
        const Number &top = column.colourTop[channel];
        const Number &bottom = column.colourBottom[channel];
        return numerator(top) * bottom.denominator - numerator(bottom) * top.denominator;
    }
    template <class Column>
    static Int128 heightOf(const Column &column, std::size_t channel)
    {
        return numerator(column.yTop) * column.colourBottom[channel].denominator
            - numerator(column.yBottom) * column.colourTop[channel].denominator;
    }
};

/// The column scan with departures, for triangles that have area. It has the same functions as
/// RightScan.
struct VariedScan {
    template <class A>
    using Ramp = LiteralRamp<A>;
    template <class A>
    static constexpr bool boundsMayCross = true;

    VariantSet variants;

    struct Edge {
        Vertex a, b;
    };

    template <class A>
    static bool represents(const LatticePoint &point)
    {
        return A::represents(point) && Ramp<A>::represents(point);
    }

    /// Divided by Δ ∓ 1, an edge has the slope of one whose other end is a pixel nearer or farther;
    /// without a pre-step it is one that begins at its first column. An edge of at most a pixel,
    /// where Δ − 1 leaves nothing, stays at its first vertex; one along the column has no slope.
    constexpr Edge edge(const Vertex &a, const Vertex &b) const
    {
        Edge edge{a, b};
        if (a.position.x == b.position.x)
            return edge;
        if (variants.contains(Variant::DivisorMinusOne))
            edge.b.position.x = std::max(b.position.x - unitsPerPixel, a.position.x);
        if (variants.contains(Variant::DivisorPlusOne))
            edge.b.position.x += unitsPerPixel;
        if (variants.contains(Variant::NoEdgePreStep)) {
            const Lattice late = ceilPixel(a.position.x) * unitsPerPixel - a.position.x;
            edge.a.position.x += late;
            edge.b.position.x += late;
        }
        return edge;
    }

    template <class Number>
    static bool isBelow(const Number &a, const Number &b)
    {
        return a < b;
    }
    /// |remainder| < denominator < 2^33.
    static bool isBelow(const MixedNumber<Int128> &a, const MixedNumber<Int128> &b)
    {
        return a.whole != b.whole ? a.whole < b.whole
                                  : a.remainder * b.denominator < b.remainder * a.denominator;
    }

    /// R_B belongs to y_B; without a pre-step it serves as the colour of the first row.
    template <class AnyRamp, class Column>
    auto starts(const AnyRamp &ramp, const Column &column) const
    {
        const bool hasPreStep = !variants.contains(Variant::NoColourPreStep);
        return ramp.startsFrom(hasPreStep ? column.yBottom : AnyRamp::wholeRow(column.firstRow),
                               column, column.firstDrawn);
    }
};

/// The triangle with sorted vertices but colours in the order given: the i-th vertex in sorted
/// order gets the i-th colour.
constexpr Triangle withUnsortedColours(const Triangle &triangle, const std::array<int, 3> &order)
{
    Triangle result = triangle;
    for (std::size_t i = 0; i < 3; ++i)
        result.vertices[std::size_t(order[i])].colour = triangle.vertices[i].colour;
    return result;
}

} // namespace pixelplumb
