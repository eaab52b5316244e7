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

/// Up to 2^15 px: the edges lie in the box, and W'·max|Y| <= 2^24·2^23.
constexpr bool containsNarrow(const Triangle &triangle) { return containsPlane(triangle); }

} // namespace biasdomain

/// The column scan's numbers in float64 with half-quantum bias: y = y₀ + (x − x₀)·m, a multiple of
/// 1/(ΔX·S) px, with β = 1/(2·ΔX·S); and colours from the plane c₀ + g_x·Δx + g_y·Δy, multiples of
/// 1/A, with 1/(4A), because ⌊v + 1/2⌋ looks at halves too (resources/numerics.md, 3.2 and 3.3 c).
/// BiasNumber serves only triangles in the proved domain; BiasOrExactNumber serves any: edges and
/// planes outside the domain are computed in integers. Inside it both give the same numbers.
template <class AnyNumber>
struct BiasArithmetic {
    using Number = AnyNumber;
    using Exact = ExactArithmetic<Int128>;
    static constexpr Arithmetic arithmetic = Arithmetic::Float64;
    static constexpr bool boundsMayCross = false; ///< by less than the bias, which undoes it
    static constexpr bool canBeExact = std::is_same_v<Number, BiasOrExactNumber>;

    static constexpr bool represents(const LatticePoint &) { return true; }

    /// The distance from a vertex to a column, lattice units.
    static Lattice runTo(std::int64_t column, const Vertex &a)
    {
        return column * unitsPerPixel - a.position.x;
    }
    static Number edgeOrdinate(const Vertex &a, const Vertex &b, Lattice run, const Number &slope)
    {
        if constexpr (canBeExact) {
            if (slope.isExact)
                return Exact::edgeOrdinate(a, b, run, slope.exact);
        }
        const Lattice width = b.position.x - a.position.x;
        return BiasNumber{inPixels(a.position.y), inPixels(run), biasedOf(slope).value(),
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
    static Number edgeColour(const Vertex &a, const Vertex &b, std::size_t channel, Lattice run,
                             const Number &rate)
    {
        if constexpr (canBeExact) {
            if (rate.isExact)
                return Exact::edgeColour(a, b, channel, run, rate.exact);
        }
        const Lattice width = b.position.x - a.position.x;
        return BiasNumber{double(a.colour.channels[channel]), inPixels(run), biasedOf(rate).value(),
                          0.25 / double(width == 0 ? 1 : width)};
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
        static constexpr bool readsEdges = false;

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
            const LevelPlane<Lattice> plane(p0, p1, p2);
            m_hasPlane = plane.area != 0;
            m_bias = m_hasPlane ? 0.25 / double(plane.area) : 0;
            m_origin = threeOf([&](std::size_t i) { return double(p0.colour.channels[i]); });
            for (std::size_t channel = 0; channel < 3 && m_hasPlane; ++channel) {
                m_perColumn[channel]
                    = double(plane.perX[channel] * unitsPerPixel) / double(plane.area);
                m_perRow[channel]
                    = double(plane.perY[channel] * unitsPerPixel) / double(plane.area);
            }
        }

        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> rates(const ColumnState &column) const
        {
            if constexpr (canBeExact) {
                if (m_hasPlane && m_exact)
                    return numbersOf(m_exact->rates(ExactPlace{column.x, {}}));
            }
            return threeOf([&](std::size_t channel) -> Number {
                if (m_hasPlane)
                    return BiasNumber{m_perRow[channel]};
                if (isVertical())
                    return BiasNumber{segmentRate(channel)};
                if constexpr (canBeExact) {
                    if (column.colourBottom[channel].isExact)
                        return MixedNumber<Int128>{0, 0,
                                                   column.colourBottom[channel].exact.denominator};
                }
                return BiasNumber{};
            });
        }

        template <class ColumnState>
        [[gnu::always_inline]] std::array<Number, 3> starts(const ColumnState &column,
                                                            std::int64_t row) const
        {
            if (!m_hasPlane && !isVertical())
                return column.colourBottom;
            if constexpr (canBeExact) {
                if (m_hasPlane && m_exact)
                    return numbersOf(m_exact->starts(ExactPlace{column.x, {}}, row));
            }
            const double run = inPixels(row * unitsPerPixel - m_p0->position.y);
            const double along = inPixels(runTo(column.x, *m_p0));
            return threeOf([&](std::size_t channel) -> Number {
                if (m_hasPlane)
                    return BiasNumber{m_origin[channel] + m_perColumn[channel] * along, run,
                                      m_perRow[channel], m_bias};
                return BiasNumber{m_origin[channel], run, segmentRate(channel),
                                  0.25 / double(m_p2->position.y - m_p0->position.y)};
            });
        }

    private:
        /// What the exact plane reads of a column; the colours only where there is no plane.
        struct ExactPlace {
            std::int64_t x;
            std::array<MixedNumber<Int128>, 3> colourBottom;
        };
        static std::array<Number, 3> numbersOf(const std::array<MixedNumber<Int128>, 3> &exact)
        {
            return threeOf([&](std::size_t channel) { return Number(exact[channel]); });
        }

        /// For a triangle of zero area: whether all samples lie on one column.
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
        std::optional<Exact::ColourRamp> m_exact; ///< outside the proved domain
        bool m_hasPlane = false;
        double m_bias = 0; ///< of the plane, levels
        std::array<double, 3> m_origin = {}; ///< levels of P0
        std::array<double, 3> m_perColumn = {}; ///< levels
        std::array<double, 3> m_perRow = {};
    };

private:
    static double inPixels(Lattice units) { return double(units) / double(unitsPerPixel); }
    static const BiasNumber &biasedOf(const BiasNumber &number) { return number; }
    static const BiasNumber &biasedOf(const BiasOrExactNumber &number) { return number.biased; }
    /// px per column; 0 for a vertical edge.
    static double slopeOf(const Vertex &a, const Vertex &b)
    {
        const Lattice width = b.position.x - a.position.x;
        return width == 0 ? 0 : double(b.position.y - a.position.y) / double(width);
    }
    /// Levels per column; 0 for a vertical edge.
    static double colourRateOf(const Vertex &a, const Vertex &b, std::size_t channel)
    {
        const Lattice width = b.position.x - a.position.x;
        return width == 0
            ? 0
            : double(b.colour.channels[channel] - a.colour.channels[channel]) / inPixels(width);
    }
};

} // namespace pixelplumb
