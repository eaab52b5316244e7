// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/straightloop.h"

namespace pixelplumb {

/// Where an edge meets the columns, exactly: whole + remainder / denominator px.
struct StraightEdge {
    std::int64_t whole = 0, remainder = 0, denominator = 1;
    std::int64_t perColumn = 0, remainderPerColumn = 0;

    StraightEdge(const Vertex &a, const Vertex &b, std::int64_t column)
    {
        const std::int64_t width = b.position.x - a.position.x;
        const std::int64_t rise = b.position.y - a.position.y;
        denominator = (width == 0 ? 1 : width) * unitsPerPixel;
        const std::int64_t run = column * unitsPerPixel - a.position.x;
        const std::int64_t numerator
            = width == 0 ? a.position.y : a.position.y * width + run * rise;
        divide(numerator, whole, remainder);
        divide(width == 0 ? 0 : rise * unitsPerPixel, perColumn, remainderPerColumn);
    }
    std::int64_t ceil() const { return whole + (remainder != 0 ? 1 : 0); }
    void step()
    {
        whole += perColumn;
        remainder += remainderPerColumn;
        if (remainder >= denominator) {
            remainder -= denominator;
            ++whole;
        }
    }

private:
    void divide(std::int64_t numerator, std::int64_t &quotient, std::int64_t &rest) const
    {
        quotient = numerator / denominator;
        rest = numerator % denominator;
        if (rest < 0) {
            --quotient;
            rest += denominator;
        }
    }
};

} // namespace pixelplumb
