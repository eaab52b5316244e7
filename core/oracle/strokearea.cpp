// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/strokeoutline.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

/// ∫ y dx of the edge within the square around the origin, y clamped between its sides; the edge
/// runs to the right, and meets the square's columns.
BigRational integralOf(const OutlinePoint &a, const OutlinePoint &b)
{
    const std::int64_t left = std::max(a.x, -halfSquare);
    const std::int64_t right = std::min(b.x, halfSquare);
    if (std::min(a.y, b.y) >= halfSquare)
        return BigRational(halfSquare) * (right - left);
    if (std::max(a.y, b.y) <= -halfSquare)
        return BigRational(-halfSquare) * (right - left);
    const BigRational slope(b.y - a.y, b.x - a.x);
    const auto heightAt
        = [&](const BigRational &x) { return BigRational(a.y + slope * (x - a.x)); };
    std::vector<BigRational> stops = {left, right};
    for (const std::int64_t side : {-halfSquare, halfSquare}) {
        if (slope == 0)
            continue;
        const BigRational x = a.x + (side - a.y) / slope;
        if (x > left && x < right)
            stops.push_back(x);
    }
    std::ranges::sort(stops);
    BigRational sum = 0;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const BigRational middle = heightAt((stops[i] + stops[i + 1]) / 2);
        const BigRational held
            = std::clamp<BigRational>(middle, BigRational(-halfSquare), BigRational(halfSquare));
        sum += held * (stops[i + 1] - stops[i]);
    }
    return sum;
}

} // namespace

BigRational strokeArea(const std::vector<OutlineEdge> &edges, const OutlinePoint &centre)
{
    BigRational sum = 0;
    for (const OutlineEdge &edge : edges) {
        const OutlinePoint a = {edge.from.x - centre.x, edge.from.y - centre.y};
        const OutlinePoint b = {edge.to.x - centre.x, edge.to.y - centre.y};
        if (a.x == b.x || std::max(a.x, b.x) <= -halfSquare || std::min(a.x, b.x) >= halfSquare)
            continue;
        if (a.x < b.x)
            sum -= integralOf(a, b);
        else
            sum += integralOf(b, a);
    }
    return sum / (BigRational(outlinePixel) * outlinePixel);
}

int strokeWinding(const std::vector<OutlineEdge> &edges, const OutlinePoint &point)
{
    int winding = 0;
    for (const OutlineEdge &edge : edges) {
        const bool goesRight = edge.from.x < edge.to.x;
        const OutlinePoint &a = goesRight ? edge.from : edge.to;
        const OutlinePoint &b = goesRight ? edge.to : edge.from;
        if (a.x > point.x || b.x <= point.x)
            continue;
        // Positive above the edge's line.
        const Int128 above
            = Int128(point.y - a.y) * (b.x - a.x) - Int128(point.x - a.x) * (b.y - a.y);
        // On the line, the displacement to the right leads above it where the line does not rise.
        if (above > 0 || (above == 0 && b.y <= a.y))
            winding += goesRight ? 1 : -1;
    }
    return winding;
}

} // namespace pixelplumb::oracle
