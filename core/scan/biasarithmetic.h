// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/biasnumber.h"
#include "core/scan/exactarithmetic.h"

#include <algorithm>

namespace pixelplumb {

/// The column scan's numbers in float64 with half-quantum bias: y = y₀ + (x − x₀)·m, a multiple of
/// 1/(ΔX·S) px, with β = 1/(2·ΔX·S); and colours from the plane c₀ + g_x·Δx + g_y·Δy, multiples of
/// 1/A, with 1/(4A), because ⌊v + 1/2⌋ asks for halves too (numerics.md, 3.2 and 3.3 c). Edges and
/// triangles outside the proved domain are computed in integers.
struct BiasArithmetic {
    using Number = BiasNumber;
    using Exact = ExactArithmetic<Int128>;
    static constexpr Arithmetic arithmetic = Arithmetic::Float64;

    /// W'·H' <= 2^40 in lattice units: with u = 2^-53 the colour's error stays below 1/(4A).
    static constexpr Int128 largestProvedArea = Int128(1) << 40;
    /// W'·max|Y| <= 2^50: then u·(2|Δx·m| + 2|y|) < 1/(2·ΔX·S).
    static constexpr Int128 largestProvedReach = Int128(1) << 50;

    static constexpr bool represents(const LatticePoint &) { return true; }

    static constexpr bool isProved(const Vertex &a, const Vertex &b)
    {
        const Int128 width = b.position.x - a.position.x;
        const Int128 height = absolute(b.position.y - a.position.y);
        const Int128 reach = std::max(absolute(a.position.y), absolute(b.position.y));
        return width * height <= largestProvedArea && width * reach <= largestProvedReach;
    }

    static Number edgeOrdinate(const Vertex &a, const Vertex &b, std::int64_t column)
    {
        if (!isProved(a, b))
            return exactly(Exact::edgeOrdinate(a, b, column));
        Number number = edgeSlope(a, b);
        const Lattice width = b.position.x - a.position.x;
        number.rate = number.origin;
        number.origin = inPixels(a.position.y);
        number.run = runTo(column, a);
        number.bias = 0.5 / (double(width == 0 ? 1 : width) * double(unitsPerPixel));
        return number;
    }
    static Number edgeSlope(const Vertex &a, const Vertex &b)
    {
        if (!isProved(a, b))
            return exactly(Exact::edgeSlope(a, b));
        const Lattice width = b.position.x - a.position.x;
        Number number;
        if (width != 0)
            number.origin = double(b.position.y - a.position.y) / double(width);
        return number;
    }
    static Number edgeColour(const Vertex &a, const Vertex &b, std::size_t channel,
                             std::int64_t column)
    {
        if (!isProved(a, b))
            return exactly(Exact::edgeColour(a, b, channel, column));
        Number number = edgeColourRate(a, b, channel);
        const Lattice width = b.position.x - a.position.x;
        number.rate = number.origin;
        number.origin = double(a.colour.channels[channel]);
        number.run = runTo(column, a);
        number.bias = 0.25 / double(width == 0 ? 1 : width);
        return number;
    }
    static Number edgeColourRate(const Vertex &a, const Vertex &b, std::size_t channel)
    {
        if (!isProved(a, b))
            return exactly(Exact::edgeColourRate(a, b, channel));
        Number number;
        if (a.position.x != b.position.x)
            number.origin = double(b.colour.channels[channel] - a.colour.channels[channel])
                / inPixels(b.position.x - a.position.x);
        return number;
    }

    static std::int64_t floor(const Number &number) { return number.floor(); }
    static std::int64_t ceil(const Number &number) { return number.ceil(); }
    static void advance(Number &number, const Number &rate)
    {
        if (number.isExact)
            number.exact.advance(rate.exact);
        else
            number.run += 1;
    }

    static std::int64_t level(const Number &number, ByteRounding rounding)
    {
        if (number.isExact)
            return Exact::level(number.exact, rounding);
        const double half = rounding == ByteRounding::Nearest ? 0.5 : 0.0;
        return std::int64_t(std::floor(number.value() + (half + number.bias)));
    }

    class ColourRamp {
    public:
        ColourRamp(const Vertex &p0, const Vertex &p1, const Vertex &p2)
            : m_p0(&p0)
            , m_p2(&p2)
            , m_exact(p0, p1, p2)
        {
            const Int128 x1 = p1.position.x - p0.position.x;
            const Int128 y1 = p1.position.y - p0.position.y;
            const Int128 x2 = p2.position.x - p0.position.x;
            const Int128 y2 = p2.position.y - p0.position.y;
            const Int128 height = std::max({Int128(0), y1, y2}) - std::min({Int128(0), y1, y2});
            m_isProved = x2 * height <= largestProvedArea;
            const Int128 area = x1 * y2 - x2 * y1;
            m_area = double(area < 0 ? -area : area);
            for (std::size_t channel = 0; channel < 3 && area != 0; ++channel) {
                const Int128 c0 = p0.colour.channels[channel];
                const Int128 c1 = p1.colour.channels[channel] - c0;
                const Int128 c2 = p2.colour.channels[channel] - c0;
                m_perColumn[channel] = double((c1 * y2 - c2 * y1) * unitsPerPixel) / double(area);
                m_perRow[channel] = double((c2 * x1 - c1 * x2) * unitsPerPixel) / double(area);
            }
        }

        template <class ColumnState>
        Number rate(const ColumnState &column, std::size_t channel) const
        {
            if (m_area != 0 && !m_isProved)
                return exactly(m_exact.rate(ExactPlace{column.x, {}}, channel));
            Number number;
            if (m_area != 0)
                number.origin = m_perRow[channel];
            else if (isVertical())
                number.origin = segmentRate(channel);
            else if (column.colourBottom[channel].isExact)
                return exactly({0, 0, column.colourBottom[channel].exact.denominator});
            return number;
        }

        template <class ColumnState>
        Number start(const ColumnState &column, std::size_t channel, std::int64_t row) const
        {
            if (m_area == 0 && !isVertical())
                return column.colourBottom[channel];
            if (m_area != 0 && !m_isProved)
                return exactly(m_exact.start(ExactPlace{column.x, {}}, channel, row));
            Number number;
            number.origin = double(m_p0->colour.channels[channel]);
            number.run = inPixels(row * unitsPerPixel - m_p0->position.y);
            if (m_area != 0) {
                number.origin += m_perColumn[channel] * runTo(column.x, *m_p0);
                number.rate = m_perRow[channel];
                number.bias = 0.25 / m_area;
            } else {
                number.rate = segmentRate(channel);
                number.bias = 0.25 / double(m_p2->position.y - m_p0->position.y);
            }
            return number;
        }

    private:
        /// What the exact plane asks of a column; the colours only where there is no plane.
        struct ExactPlace {
            std::int64_t x;
            std::array<MixedNumber<Int128>, 3> colourBottom;
        };

        /// Of a triangle of zero area: all samples lie on one column.
        bool isVertical() const
        {
            return m_p0->position.x == m_p2->position.x && m_p0->position.y != m_p2->position.y;
        }
        double segmentRate(std::size_t channel) const
        {
            return double(m_p2->colour.channels[channel] - m_p0->colour.channels[channel])
                / inPixels(m_p2->position.y - m_p0->position.y);
        }

        const Vertex *m_p0;
        const Vertex *m_p2;
        Exact::ColourRamp m_exact;
        bool m_isProved = false;
        double m_area = 0; ///< doubled, without sign, in square lattice units
        std::array<double, 3> m_perColumn = {}; ///< levels
        std::array<double, 3> m_perRow = {};
    };

private:
    static double inPixels(Lattice units) { return double(units) / double(unitsPerPixel); }
    static double runTo(std::int64_t column, const Vertex &a)
    {
        return inPixels(column * unitsPerPixel - a.position.x);
    }
    static Number exactly(const MixedNumber<Int128> &mixed)
    {
        Number number;
        number.isExact = true;
        number.exact = mixed;
        return number;
    }
};

} // namespace pixelplumb
