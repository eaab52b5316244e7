// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/exactarithmetic.h"
#include "core/scan/roundedarithmetic.h"

#include <type_traits>

namespace pixelplumb {

/// A fraction of integers, rounded once.
template <class Value>
struct RoundedFraction {
    static Value of(Int128 numerator, Int128 denominator)
    {
        return Value(numerator) / Value(denominator);
    }
};

template <class Raw, class Product, int FractionBits>
struct RoundedFraction<FixedPoint<Raw, Product, FractionBits>> {
    /// numerator| < 2^66, so that the scaled one fits; a result out of range wraps.
    static FixedPoint<Raw, Product, FractionBits> of(Int128 numerator, Int128 denominator)
    {
        const Int128 scaled = numerator * (Int128(1) << FractionBits);
        const auto nearest = floorDivide<Int128>(2 * scaled + denominator, 2 * denominator);
        return FixedPoint<Raw, Product, FractionBits>::fromRaw(
            Raw(std::make_unsigned_t<Raw>(nearest)));
    }
};

/// The assignment's increments with one change: ΔR is computed once, from the plane through the
/// three vertices, where it is the same for all columns (resources/numerics.md, 3.3). Taken anew
/// from each column's two drifting bounds, it divides rounding errors by almost nothing in thin
/// triangles.
template <class Base>
struct ConstantRateArithmetic : Base {
    using typename Base::Number;

    class ColourRamp {
        using Integer = WideBeside<Number>;

    public:
        static constexpr bool readsEdges = Base::ColourRamp::readsEdges;

        ColourRamp(const Vertex &p0, const Vertex &p1, const Vertex &p2)
            : m_ofColumn(p0, p1, p2)
        {
            const Integer x1 = Integer(p1.position.x) - p0.position.x;
            const Integer y1 = Integer(p1.position.y) - p0.position.y;
            const Integer x2 = Integer(p2.position.x) - p0.position.x;
            const Integer y2 = Integer(p2.position.y) - p0.position.y;
            const Integer area = x1 * y2 - x2 * y1;
            m_hasPlane = area != 0;
            for (std::size_t channel = 0; channel < 3 && m_hasPlane; ++channel) {
                const Integer c0 = p0.colour.channels[channel];
                const Integer c1 = p1.colour.channels[channel] - c0;
                const Integer c2 = p2.colour.channels[channel] - c0;
                const Integer rise = (c2 * x1 - c1 * x2) * unitsPerPixel;
                m_rate[channel]
                    = RoundedFraction<Number>::of(area < 0 ? -rise : rise, area < 0 ? -area : area);
            }
        }

        /// A triangle of zero area has no plane and keeps each column's own rate.
        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> rates(const ColumnState &column) const
        {
            return m_hasPlane ? m_rate : m_ofColumn.rates(column);
        }
        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> starts(const ColumnState &column,
                                                            std::int64_t row) const
        {
            return m_ofColumn.starts(column, row);
        }

    private:
        typename Base::ColourRamp m_ofColumn;
        bool m_hasPlane = false;
        std::array<Number, 3> m_rate = {}; ///< levels per row
    };
};

/// The exact column scan already takes its ΔR from the plane.
template <class Integer>
struct ConstantRateArithmetic<ExactArithmetic<Integer>> : ExactArithmetic<Integer> {
};

} // namespace pixelplumb
