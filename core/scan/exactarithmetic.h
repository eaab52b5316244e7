// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/levelplane.h"
#include "core/number/mixednumber.h"
#include "core/number/three.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// The column scan's numbers as integer quotients and remainders: the assignment's increments
/// without rounding. Integer is std::int64_t up to 2^15 px and Int128 beyond
/// (resources/numerics.md, 3.1 and 3.3).
template <class Integer>
struct ExactArithmetic {
    using Number = MixedNumber<Integer>;
    static constexpr Arithmetic arithmetic = Arithmetic::Exact;
    /// Whether rounding can take the two bounds of a column past each other.
    static constexpr bool boundsMayCross = false;

    /// Every lattice point is an integer; the caller chooses the width that holds the products.
    static constexpr bool represents(const LatticePoint &) { return true; }

    /// The distance from a vertex to a column, lattice units.
    static constexpr Integer runTo(std::int64_t column, const Vertex &a)
    {
        return Integer(column) * unitsPerPixel - a.position.x;
    }
    /// The edge's y at a column: (Ya·ΔX + (x·S − Xa)·ΔY) / (ΔX·S) px; a vertical edge stays at a.
    [[gnu::always_inline]] static constexpr Number edgeOrdinate(const Vertex &a, const Vertex &b,
                                                                const Integer &run, const Number &)
    {
        const Integer width = Integer(b.position.x) - a.position.x;
        if (width == 0)
            return Number::fromFraction(a.position.y, unitsPerPixel);
        const Integer height = Integer(b.position.y) - a.position.y;
        return Number::fromFraction(a.position.y * width + run * height, width * unitsPerPixel);
    }
    [[gnu::always_inline]] static constexpr Number edgeSlope(const Vertex &a, const Vertex &b)
    {
        const Integer width = Integer(b.position.x) - a.position.x;
        const Integer height = Integer(b.position.y) - a.position.y;
        if (width == 0)
            return {0, 0, unitsPerPixel};
        return Number::fromFraction(height * unitsPerPixel, width * unitsPerPixel);
    }
    /// The edge's colour level at a column: (ca·ΔX + (x·S − Xa)·(cb − ca)) / ΔX.
    static constexpr Number edgeColour(const Vertex &a, const Vertex &b, std::size_t channel,
                                       const Integer &run, const Number &)
    {
        const Integer width = Integer(b.position.x) - a.position.x;
        const Integer from = a.colour.channels[channel];
        if (width == 0)
            return Number::fromFraction(from, 1);
        const Integer rise = Integer(b.colour.channels[channel]) - from;
        return Number::fromFraction(from * width + run * rise, width);
    }
    static constexpr Number edgeColourRate(const Vertex &a, const Vertex &b, std::size_t channel)
    {
        const Integer width = Integer(b.position.x) - a.position.x;
        if (width == 0)
            return Number::fromFraction(0, 1);
        const Integer rise = Integer(b.colour.channels[channel]) - a.colour.channels[channel];
        return Number::fromFraction(rise * unitsPerPixel, width);
    }

    static constexpr std::int64_t floor(const Number &number) { return number.floor(); }
    static constexpr std::int64_t ceil(const Number &number) { return number.ceil(); }
    static constexpr void advance(Number &number, const Number &rate) { number.advance(rate); }

    static constexpr std::int64_t level(const Number &number, ByteRounding rounding)
    {
        const bool up = rounding == ByteRounding::Nearest
            && number.remainder >= number.denominator - number.remainder;
        return std::int64_t(number.whole + std::int64_t(up));
    }

    /// ΔR = (R_T − R_B)/(y_T − y_B) is GY·S/A of the level's plane in every column, and R_B +
    /// (⌈y_B⌉ − y_B)·ΔR is the plane's value there: the same numbers as the assignment's, each one
    /// division from integers.
    class ColourRamp {
    public:
        /// Whether a triangle that has area needs its edges' colours.
        static constexpr bool readsEdges = false;

        ColourRamp(const Vertex &p0, const Vertex &p1, const Vertex &p2)
            : m_p0(&p0)
            , m_p2(&p2)
            , m_plane(p0, p1, p2)
        {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                if (m_plane.area != 0)
                    m_rate[channel]
                        = Number::fromFraction(m_plane.perY[channel] * unitsPerPixel, m_plane.area);
            }
        }

        /// ΔR ΔG ΔB of a column.
        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> rates(const ColumnState &column) const
        {
            if (m_plane.area != 0)
                return m_rate;
            const Integer height = m_p2->position.y - m_p0->position.y;
            const bool isVertical = m_p0->position.x == m_p2->position.x && height != 0;
            std::array<Number, 3> rates;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                rates[channel] = isVertical
                    ? Number::fromFraction(rise(channel) * unitsPerPixel, height)
                    : Number::fromFraction(0, column.colourBottom[channel].denominator);
            }
            return rates;
        }

        /// R G B at a row of the column.
        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> starts(const ColumnState &column,
                                                            std::int64_t row) const
        {
            const Integer up = Integer(row) * unitsPerPixel - m_p0->position.y;
            if (m_plane.area != 0) {
                const Integer along = Integer(column.x) * unitsPerPixel - m_p0->position.x;
                return threeOf([&](std::size_t channel) {
                    return Number::fromFraction(m_plane.numerator(*m_p0, channel, along, up),
                                                m_plane.area);
                });
            }
            const Integer height = m_p2->position.y - m_p0->position.y;
            if (m_p0->position.x != m_p2->position.x || height == 0)
                return column.colourBottom;
            std::array<Number, 3> starts;
            for (std::size_t channel = 0; channel < 3; ++channel)
                starts[channel] = Number::fromFraction(
                    Integer(m_p0->colour.channels[channel]) * height + rise(channel) * up, height);
            return starts;
        }

    private:
        Integer rise(std::size_t channel) const
        {
            return Integer(m_p2->colour.channels[channel]) - m_p0->colour.channels[channel];
        }

        const Vertex *m_p0;
        const Vertex *m_p2;
        LevelPlane<Integer> m_plane;
        std::array<Number, 3> m_rate = {}; ///< ΔR ΔG ΔB, levels per row
    };
};

} // namespace pixelplumb
