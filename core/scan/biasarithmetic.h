// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/biasnumber.h"
#include "core/scan/exactarithmetic.h"

#include <algorithm>
#include <optional>
#include <type_traits>

namespace pixelplumb {

/// The domain in which half-quantum bias is proved.
namespace biasdomain {

/// W'·H' <= 2^40 in lattice units: with u = 2^-53 the colour's error stays below 1/(4A).
inline constexpr Int128 largestArea = Int128(1) << 40;
/// W'·max|Y| <= 2^50: then u·(2|Δx·m| + 2|y|) < 1/(2·ΔX·S).
inline constexpr Int128 largestReach = Int128(1) << 50;

constexpr bool containsEdge(const LatticePoint &a, const LatticePoint &b)
{
    const Int128 width = absolute(b.x - a.x);
    return width * absolute(b.y - a.y) <= largestArea
        && width * std::max(absolute(a.y), absolute(b.y)) <= largestReach;
}

/// Width times height of the bounding box.
constexpr bool containsPlane(const Triangle &triangle)
{
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    return Int128(right - left) * (high - low) <= largestArea;
}

constexpr bool contains(const Triangle &triangle)
{
    const auto &v = triangle.vertices;
    return containsPlane(triangle) && containsEdge(v[0].position, v[1].position)
        && containsEdge(v[1].position, v[2].position) && containsEdge(v[2].position, v[0].position);
}

} // namespace biasdomain

/// The column scan's numbers in float64 with half-quantum bias: y = y₀ + (x − x₀)·m, a multiple of
/// 1/(ΔX·S) px, with β = 1/(2·ΔX·S); and colours from the plane c₀ + g_x·Δx + g_y·Δy, multiples of
/// 1/A, with 1/(4A), because ⌊v + 1/2⌋ asks for halves too (resources/numerics.md, 3.2 and 3.3 c).
/// With BiasNumber for triangles in the proved domain alone; with BiasOrExactNumber for any: edges
/// and planes beyond it are computed in integers. Where both can, their numbers are the same.
template <class AnyNumber>
struct BiasArithmetic {
    using Number = AnyNumber;
    using Exact = ExactArithmetic<Int128>;
    static constexpr Arithmetic arithmetic = Arithmetic::Float64;
    static constexpr bool boundsMayCross = false; ///< by less than the bias, which undoes it
    static constexpr bool canBeExact = std::is_same_v<Number, BiasOrExactNumber>;

    static constexpr bool represents(const LatticePoint &) { return true; }

    static Number edgeOrdinate(const Vertex &a, const Vertex &b, std::int64_t column)
    {
        if constexpr (canBeExact) {
            if (!biasdomain::containsEdge(a.position, b.position))
                return Exact::edgeOrdinate(a, b, column);
        }
        const Lattice width = b.position.x - a.position.x;
        return BiasNumber{inPixels(a.position.y), runTo(column, a), slopeOf(a, b),
                          0.5 / (double(width == 0 ? 1 : width) * double(unitsPerPixel))};
    }
    static Number edgeSlope(const Vertex &a, const Vertex &b)
    {
        if constexpr (canBeExact) {
            if (!biasdomain::containsEdge(a.position, b.position))
                return Exact::edgeSlope(a, b);
        }
        return BiasNumber{slopeOf(a, b)};
    }
    static Number edgeColour(const Vertex &a, const Vertex &b, std::size_t channel,
                             std::int64_t column)
    {
        if constexpr (canBeExact) {
            if (!biasdomain::containsEdge(a.position, b.position))
                return Exact::edgeColour(a, b, channel, column);
        }
        const Lattice width = b.position.x - a.position.x;
        return BiasNumber{double(a.colour.channels[channel]), runTo(column, a),
                          colourRateOf(a, b, channel), 0.25 / double(width == 0 ? 1 : width)};
    }
    static Number edgeColourRate(const Vertex &a, const Vertex &b, std::size_t channel)
    {
        if constexpr (canBeExact) {
            if (!biasdomain::containsEdge(a.position, b.position))
                return Exact::edgeColourRate(a, b, channel);
        }
        return BiasNumber{colourRateOf(a, b, channel)};
    }

    static std::int64_t floor(const Number &number) { return number.floor(); }
    static std::int64_t ceil(const Number &number) { return number.ceil(); }
    static void advance(Number &number, const Number &rate) { number.advance(rate); }

    static std::int64_t level(const BiasNumber &number, ByteRounding rounding)
    {
        const double half = rounding == ByteRounding::Nearest ? 0.5 : 0.0;
        return floorOf(number.value() + (half + number.bias));
    }
    static std::int64_t level(const BiasOrExactNumber &number, ByteRounding rounding)
    {
        return number.isExact ? Exact::level(number.exact, rounding)
                              : level(number.biased, rounding);
    }

    class ColourRamp {
    public:
        ColourRamp(const Vertex &p0, const Vertex &p1, const Vertex &p2)
            : m_p0(&p0)
            , m_p2(&p2)
        {
            if constexpr (canBeExact) {
                if (!biasdomain::containsPlane({{p0, p1, p2}})) {
                    m_exact.emplace(p0, p1, p2);
                    m_hasPlane = doubledArea(p0.position, p1.position, p2.position) != 0;
                    return;
                }
            }
            // Within the domain the products fit 64 bits.
            const Lattice x1 = p1.position.x - p0.position.x;
            const Lattice y1 = p1.position.y - p0.position.y;
            const Lattice x2 = p2.position.x - p0.position.x;
            const Lattice y2 = p2.position.y - p0.position.y;
            const Lattice area = x1 * y2 - x2 * y1;
            m_hasPlane = area != 0;
            m_bias = m_hasPlane ? 0.25 / double(absolute(area)) : 0;
            for (std::size_t channel = 0; channel < 3 && m_hasPlane; ++channel) {
                const Lattice c0 = p0.colour.channels[channel];
                const Lattice c1 = p1.colour.channels[channel] - c0;
                const Lattice c2 = p2.colour.channels[channel] - c0;
                m_perColumn[channel] = double((c1 * y2 - c2 * y1) * unitsPerPixel) / double(area);
                m_perRow[channel] = double((c2 * x1 - c1 * x2) * unitsPerPixel) / double(area);
            }
        }

        template <class ColumnState>
        Number rate(const ColumnState &column, std::size_t channel) const
        {
            if constexpr (canBeExact) {
                if (m_hasPlane && m_exact)
                    return m_exact->rate(ExactPlace{column.x, {}}, channel);
                if (!m_hasPlane && !isVertical() && column.colourBottom[channel].isExact)
                    return MixedNumber<Int128>{0, 0,
                                               column.colourBottom[channel].exact.denominator};
            }
            if (m_hasPlane)
                return BiasNumber{m_perRow[channel]};
            return BiasNumber{isVertical() ? segmentRate(channel) : 0};
        }

        template <class ColumnState>
        Number start(const ColumnState &column, std::size_t channel, std::int64_t row) const
        {
            if (!m_hasPlane && !isVertical())
                return column.colourBottom[channel];
            if constexpr (canBeExact) {
                if (m_hasPlane && m_exact)
                    return m_exact->start(ExactPlace{column.x, {}}, channel, row);
            }
            BiasNumber number;
            number.origin = double(m_p0->colour.channels[channel]);
            number.run = inPixels(row * unitsPerPixel - m_p0->position.y);
            if (m_hasPlane) {
                number.origin += m_perColumn[channel] * runTo(column.x, *m_p0);
                number.rate = m_perRow[channel];
                number.bias = m_bias;
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
        std::optional<Exact::ColourRamp> m_exact; ///< beyond the proved domain
        bool m_hasPlane = false;
        double m_bias = 0; ///< of the plane, levels
        std::array<double, 3> m_perColumn = {}; ///< levels
        std::array<double, 3> m_perRow = {};
    };

private:
    static double inPixels(Lattice units) { return double(units) / double(unitsPerPixel); }
    static double runTo(std::int64_t column, const Vertex &a)
    {
        return inPixels(column * unitsPerPixel - a.position.x);
    }
    /// px per column; 0 of a vertical edge.
    static double slopeOf(const Vertex &a, const Vertex &b)
    {
        const Lattice width = b.position.x - a.position.x;
        return width == 0 ? 0 : double(b.position.y - a.position.y) / double(width);
    }
    /// Levels per column; 0 of a vertical edge.
    static double colourRateOf(const Vertex &a, const Vertex &b, std::size_t channel)
    {
        const Lattice width = b.position.x - a.position.x;
        return width == 0
            ? 0
            : double(b.colour.channels[channel] - a.colour.channels[channel]) / inPixels(width);
    }
};

} // namespace pixelplumb
