// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/operationcounts.h"

namespace pixelplumb {

namespace {

const QString &endOfLines()
{
    static const QString words = " All other operations are the colour's, whose R, G and B are "
                                 "numbers between the ends', even where these are the same.";
    return words;
}

/// What finds the places of a line's pixels, once and at each step; the rest is colour.
QString lineWords(const QString &id, Arithmetic arithmetic)
{
    const bool isExact = arithmetic == Arithmetic::Exact;
    if (id == QLatin1String("line-slope-intercept"))
        return u"For the places of the pixels, the set-up: "_s
            + (isExact
                   ? u"no division, m and b stay fractions; each step: y as a "
                     "fraction, and one division that rounds it."_s
                   : u"one division for m, one multiplication and one addition for b; each step: "
                     "one multiplication and one addition for m·x + b, and one rounding."_s);
    if (id == QLatin1String("line-dda"))
        return u"For the places of the pixels, the set-up: "_s
            + (isExact
                   ? u"one division for m and one for the first v, whose remainders are kept; each "
                     "step: additions and comparisons of quotients and remainders, no division."_s
                   : u"one division for m; each step: one addition for v + m and "
                     "one rounding."_s);
    if (id == QLatin1String("line-bresenham"))
        return u"For the places of the pixels, the set-up: 2 multiplications (2Δx and 2Δy), 4 "
               "additions (Δx, Δy, 2Δy − 2Δx and p₀) and 2 comparisons (the signs of Δx and Δy); "
               "each "
               "step: 1 comparison (p with 0) and 1 addition (to p). They take no division, no "
               "rounding and no floating point; but where the frame cuts the line's start off, one "
               "division finds the first pixel. Rounding the ends to whole pixels and comparing "
               "|Δx| "
               "with |Δy| are not counted."_s;
    if (id == QLatin1String("line-bresenham-symmetric"))
        return u"For the places of the pixels, the set-up: 1 division, which finds the first pixel "
               "from ends that need not be whole, with 15 multiplications, 10 additions and 2 "
               "comparisons; each step: 1 comparison (p with 0) and 1 addition (to p), as in the "
               "form "
               "with whole-pixel ends. They take no rounding and no floating point. Sorting the "
               "ends "
               "and comparing |Δx| with |Δy| are not counted."_s;
    return {};
}

} // namespace

QString countingGap(const Method &method, Arithmetic arithmetic)
{
    if (method.id == QLatin1String("stroke-coverage"))
        return u"Not counted: an area takes as many steps as its polygon has corners, in floating "
               "point and, where a byte depends on it, in fractions."_s;
    if (method.id == QLatin1String("bezier-subdivision"))
        return u"Not counted: it computes in integers that grow with every cut, so "
               "that one operation is not like another."_s;
    if (!isCounted(method))
        return u"Not counted."_s;
    if (method.id == QLatin1String("column-scan-bias") && arithmetic == Arithmetic::Float64)
        return u"Annotated step by step, not counted by its numbers; what integers "
               "compute outside the proved domain is not counted."_s;
    if (const QString words = lineWords(method.id, arithmetic); !words.isEmpty())
        return words + endOfLines();
    if (method.id == QLatin1String("polygon-fan") || method.id == QLatin1String("polygon-delaunay")
        || method.id == QLatin1String("polygon-tessellation"))
        return u"Finding the triangles is not counted, filling them is."_s;
    if (method.id == QLatin1String("bezier-fill"))
        return u"Finding the chords is not counted, filling them is."_s;
    if (method.id == QLatin1String("text-outlines"))
        return u"Getting the outlines from the font is not counted, filling them is."_s;
    return {};
}

} // namespace pixelplumb
