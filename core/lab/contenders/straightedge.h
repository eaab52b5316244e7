// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/straightwalk.h"

namespace pixelplumb {

/// whole + remainder / denominator, 0 <= remainder < denominator.
struct StraightQuotient {
    std::int64_t whole = 0, remainder = 0;

    StraightQuotient() = default;
    StraightQuotient(std::int64_t numerator, std::int64_t denominator)
        : whole(numerator / denominator)
        , remainder(numerator % denominator)
    {
        if (remainder < 0) {
            --whole;
            remainder += denominator;
        }
    }
    void add(const StraightQuotient &rate, std::int64_t denominator)
    {
        whole += rate.whole;
        remainder += rate.remainder;
        if (remainder >= denominator) {
            remainder -= denominator;
            ++whole;
        }
    }
};

/// Where an edge meets the columns, exactly, px.
struct QuotientEdge {
    static constexpr bool mayCross = false;

    QuotientEdge(const Vertex &from, const Vertex &to, std::int64_t column)
    {
        const LatticePoint &a = from.position, &b = to.position;
        const std::int64_t width = b.x - a.x, rise = b.y - a.y;
        const std::int64_t run = column * unitsPerPixel - a.x;
        m_denominator = (width == 0 ? 1 : width) * unitsPerPixel;
        m_y = {width == 0 ? a.y : a.y * width + run * rise, m_denominator};
        if (width != 0)
            m_slope = {rise * unitsPerPixel, m_denominator};
    }
    std::int64_t floor() const { return m_y.whole; }
    std::int64_t ceil() const { return m_y.whole + std::int64_t(m_y.remainder != 0); }
    void step() { m_y.add(m_slope, m_denominator); }

private:
    std::int64_t m_denominator = 1;
    StraightQuotient m_y, m_slope;
};

} // namespace pixelplumb
