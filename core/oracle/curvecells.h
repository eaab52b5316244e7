// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace pixelplumb::oracle {

/// One coordinate of a Bézier curve's control points. Each halving of a curve of degree n makes the
/// unit 2^n times smaller, so that nothing is ever rounded.
template <class Integer>
class CurveControlsOf {
public:
    /// Two to four control points, in units.
    CurveControlsOf(std::array<Integer, 4> points, std::size_t count)
        : m_points(std::move(points))
        , m_count(count)
    {
    }

    std::size_t degree() const { return m_count - 1; }
    const Integer &first() const { return m_points[0]; }
    const Integer &last() const { return m_points[degree()]; }
    Integer lowest() const { return *std::min_element(m_points.begin(), end()); }
    Integer highest() const { return *std::max_element(m_points.begin(), end()); }
    bool isMonotone() const
    {
        return std::is_sorted(m_points.begin(), end())
            || std::is_sorted(m_points.begin(), end(), std::greater<>());
    }
    /// Whether both coordinates change by equal amounts, in the same or in opposite directions.
    bool runsAlike(const CurveControlsOf &other) const
    {
        const auto agrees = [&](int sign) {
            for (std::size_t i = 1; i < m_count; ++i) {
                if (m_points[i] - m_points[i - 1]
                    != sign * (other.m_points[i] - other.m_points[i - 1]))
                    return false;
            }
            return true;
        };
        return agrees(1) || agrees(-1);
    }

    /// De Casteljau's repeated averages, kept as sums.
    CurveControlsOf leftHalf() const
    {
        CurveControlsOf half = *this;
        std::array<Integer, 4> sums = m_points;
        for (std::size_t level = 0; level < m_count; ++level) {
            half.m_points[level] = sums[0] * (Integer(1) << (degree() - level));
            for (std::size_t i = 0; i + level + 1 < m_count; ++i)
                sums[i] += sums[i + 1];
        }
        return half;
    }
    CurveControlsOf rightHalf() const { return reversed().leftHalf().reversed(); }

private:
    auto end() const { return m_points.begin() + std::ptrdiff_t(m_count); }
    CurveControlsOf reversed() const
    {
        CurveControlsOf other = *this;
        std::reverse(other.m_points.begin(), other.m_points.begin() + std::ptrdiff_t(m_count));
        return other;
    }

    std::array<Integer, 4> m_points;
    std::size_t m_count;
};

using CurveControls = CurveControlsOf<boost::multiprecision::cpp_int>;

/// A run of unit cells [k, k + 1).
struct CellRange {
    std::int64_t first = 0;
    std::int64_t last = 0;

    bool isOne() const { return first == last; }
};

/// Where one coordinate of a piece of a curve lies among cells of the pixel's size.
class CurveExtent {
public:
    using Integer = boost::multiprecision::cpp_int;

    CurveExtent(const CurveControls &controls, const Integer &pixel)
        : m_atFirst(cellOf(controls.first(), pixel))
        , m_atLast(cellOf(controls.last(), pixel))
        , m_isFirstOnBorder(controls.first() % pixel == 0)
        , m_isLastOnBorder(controls.last() % pixel == 0)
    {
        const Integer low = controls.lowest();
        const Integer high = controls.highest();
        m_cells.first = cellOf(low, pixel);
        // A curve reaches its highest control point only at an end, unless it is constant.
        m_cells.last = std::max({m_atFirst, m_atLast, cellOf(high - 1, pixel)});
        m_isLowOnBorder = low % pixel == 0;
        m_isConstant = low == high;
    }

    const CellRange &cells() const { return m_cells; }
    std::int64_t atFirst() const { return m_atFirst; }
    std::int64_t atLast() const { return m_atLast; }
    bool isFirstOnBorder() const { return m_isFirstOnBorder; }
    bool isLastOnBorder() const { return m_isLastOnBorder; }
    bool isClearOfLowBorder() const { return !m_isLowOnBorder; }
    /// For a piece that crosses or touches at most one border.
    bool meetsBorder() const { return !m_cells.isOne() || (m_isConstant && m_isLowOnBorder); }

private:
    static std::int64_t cellOf(const Integer &coordinate, const Integer &pixel)
    {
        Integer quotient, remainder;
        boost::multiprecision::divide_qr(coordinate, pixel, quotient, remainder);
        return std::int64_t(quotient) - (remainder < 0 ? 1 : 0);
    }

    CellRange m_cells;
    std::int64_t m_atFirst, m_atLast;
    bool m_isFirstOnBorder, m_isLastOnBorder;
    bool m_isLowOnBorder = false;
    bool m_isConstant = false;
};

} // namespace pixelplumb::oracle
