// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightbox.h"

/// Edge equations and barycentric coordinates in integers: every sample of the box is tested.
namespace pixelplumb {

namespace {

/// Edge functions in 64-bit integers, positive inside, each facing a vertex; colours are the
/// plane's: the weighted sum over the doubled area, rounded by one division.
struct ExactLines {
    std::int64_t a[3], b[3], c[3];
    std::int64_t level[3][3];
    std::int64_t area;
    std::int64_t least[3]; ///< of the values that count as inside

    ExactLines(const Triangle &triangle, StraightLines lines, StraightRule rule)
    {
        area = std::int64_t(doubledArea(triangle));
        const std::int64_t sign = area < 0 ? -1 : 1;
        area *= sign;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t vertex = facedVertex(lines, i);
            const LatticePoint &p = triangle.vertices[(vertex + 1) % 3].position;
            const LatticePoint &q = triangle.vertices[(vertex + 2) % 3].position;
            a[i] = sign * (p.y - q.y);
            b[i] = sign * (q.x - p.x);
            c[i] = sign * (p.x * q.y - q.x * p.y);
            least[i] = straightOwnsTie(rule, a[i], b[i]) ? 0 : 1;
            for (std::size_t channel = 0; channel < 3; ++channel)
                level[i][channel] = triangle.vertices[vertex].colour.channels[channel];
        }
    }

    std::int64_t at(std::size_t i, std::int64_t x, std::int64_t y) const
    {
        return (a[i] * x + b[i] * y) * unitsPerPixel + c[i];
    }
    template <StraightRule rule>
    bool areInside(std::int64_t e0, std::int64_t e1, std::int64_t e2) const
    {
        if constexpr (rule == StraightRule::Closed)
            return (e0 | e1 | e2) >= 0;
        else
            return ((e0 - least[0]) | (e1 - least[1]) | (e2 - least[2])) >= 0;
    }
    std::int64_t sum(const std::int64_t (&e)[3], std::size_t channel) const
    {
        return e[0] * level[0][channel] + e[1] * level[1][channel] + e[2] * level[2][channel];
    }
    /// Each ⌊sum / area + ½⌋; sums inside are not negative.
    QRgb pixel(std::int64_t red, std::int64_t green, std::int64_t blue) const
    {
        const auto nearest = [&](std::int64_t sum) { return (2 * sum + area) / (2 * area); };
        return pixelOfLevels({nearest(red), nearest(green), nearest(blue)});
    }
};

template <StraightLines order, StraightRule rule>
void drawExactLines(const Triangle &triangle, RawFrame frame)
{
    const ExactLines lines(triangle, order, rule);
    const StraightBox box = straightBoxOf(triangle);
    const auto draw = [&](std::int64_t x, std::int64_t y, QRgb *pixel) {
        const std::int64_t e[3] = {lines.at(0, x, y), lines.at(1, x, y), lines.at(2, x, y)};
        if (lines.areInside<rule>(e[0], e[1], e[2]))
            *pixel = lines.pixel(lines.sum(e, 0), lines.sum(e, 1), lines.sum(e, 2));
    };
    if constexpr (order == StraightLines::OfWeights) {
        for (std::int64_t x = box.left; x <= box.right; ++x) {
            for (std::int64_t y = box.low; y <= box.high; ++y)
                draw(x, y, frame.at(x, y));
        }
    } else {
        for (std::int64_t y = box.low; y <= box.high; ++y) {
            for (std::int64_t x = box.left; x <= box.right; ++x)
                draw(x, y, frame.at(x, y));
        }
    }
}

template <StraightRule rule>
void drawExactEdgesIncremental(const Triangle &triangle, RawFrame frame)
{
    const ExactLines lines(triangle, StraightLines::OfEdges, rule);
    const StraightBox box = straightBoxOf(triangle);
    for (std::int64_t y = box.low; y <= box.high; ++y) {
        std::int64_t e[3];
        for (std::size_t i = 0; i < 3; ++i)
            e[i] = lines.at(i, box.left, y);
        QRgb *pixel = frame.at(box.left, y);
        for (std::int64_t x = box.left; x <= box.right; ++x, pixel += frame.perU) {
            if (lines.areInside<rule>(e[0], e[1], e[2]))
                *pixel = lines.pixel(lines.sum(e, 0), lines.sum(e, 1), lines.sum(e, 2));
            for (std::size_t i = 0; i < 3; ++i)
                e[i] += lines.a[i] * unitsPerPixel;
        }
    }
}

template <StraightRule rule>
void drawExactBarycentricIncremental(const Triangle &triangle, RawFrame frame)
{
    const ExactLines lines(triangle, StraightLines::OfWeights, rule);
    const StraightBox box = straightBoxOf(triangle);
    std::int64_t perY[6];
    const auto levels = [&](std::int64_t(&v)[6]) {
        for (std::size_t i = 0; i < 3; ++i)
            v[3 + i]
                = v[0] * lines.level[0][i] + v[1] * lines.level[1][i] + v[2] * lines.level[2][i];
    };
    for (std::size_t i = 0; i < 3; ++i)
        perY[i] = lines.b[i] * unitsPerPixel;
    levels(perY);
    for (std::int64_t x = box.left; x <= box.right; ++x) {
        std::int64_t v[6];
        for (std::size_t i = 0; i < 3; ++i)
            v[i] = lines.at(i, x, box.low);
        levels(v);
        QRgb *pixel = frame.at(x, box.low);
        for (std::int64_t y = box.low; y <= box.high; ++y, pixel += frame.perV) {
            if (lines.areInside<rule>(v[0], v[1], v[2]))
                *pixel = lines.pixel(v[3], v[4], v[5]);
            for (std::size_t i = 0; i < 6; ++i)
                v[i] += perY[i];
        }
    }
}

using enum StraightRule;

constexpr StraightLoop rows[] = {
    {"edge-equations", Arithmetic::Exact, SpanAxis::Column,
     drawExactLines<StraightLines::OfEdges, Closed>,
     drawExactLines<StraightLines::OfEdges, HalfOpen>},
    {"edge-equations-incremental", Arithmetic::Exact, SpanAxis::Column,
     drawExactEdgesIncremental<Closed>, drawExactEdgesIncremental<HalfOpen>},
    {"barycentric-rectangle", Arithmetic::Exact, SpanAxis::Column,
     drawExactLines<StraightLines::OfWeights, Closed>,
     drawExactLines<StraightLines::OfWeights, HalfOpen>},
    {"barycentric-incremental", Arithmetic::Exact, SpanAxis::Column,
     drawExactBarycentricIncremental<Closed>, drawExactBarycentricIncremental<HalfOpen>},
    {"barycentric-relative", Arithmetic::Exact, SpanAxis::Column,
     drawExactLines<StraightLines::OfWeights, Closed>,
     drawExactLines<StraightLines::OfWeights, HalfOpen>},
};

} // namespace

std::span<const StraightLoop> straightExactSamples() { return rows; }

} // namespace pixelplumb
