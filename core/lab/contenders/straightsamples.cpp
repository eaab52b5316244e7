// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightlines.h"

#include <algorithm>
#include <optional>

/// Edge equations and barycentric coordinates: every sample of the bounding box is tested.
namespace pixelplumb {

namespace {

using namespace straightlines;

/// Calls drawLine(x, y, pixel, pixels to the next one, samples) for each row of the bounding box,
/// or column by column, with the line's first sample.
template <Lines order, class DrawLine>
void forEachLine(const Triangle &triangle, RawFrame frame, const DrawLine &drawLine)
{
    const auto &[a, b, c] = triangle.vertices;
    const auto [west, east] = std::minmax({a.position.x, b.position.x, c.position.x});
    const auto [south, north] = std::minmax({a.position.y, b.position.y, c.position.y});
    const std::int64_t left = ceilPixel(west), right = floorPixel(east);
    const std::int64_t low = ceilPixel(south), high = floorPixel(north);
    if constexpr (order == Lines::OfWeights) {
        for (std::int64_t x = left; x <= right; ++x)
            drawLine(x, low, frame.at(x, low), frame.perV, high - low + 1);
    } else {
        for (std::int64_t y = low; y <= high; ++y)
            drawLine(left, y, frame.at(left, y), frame.perU, right - left + 1);
    }
}

/// Evaluates the lines at every sample.
template <class Samples, StraightRule rule>
void drawEvaluated(const Triangle &triangle, RawFrame frame)
{
    constexpr bool goesUp = Samples::order == Lines::OfWeights;
    const Samples lines(triangle, rule);
    forEachLine<Samples::order>(
        triangle, frame,
        [&](std::int64_t x, std::int64_t y, QRgb *pixel, std::ptrdiff_t step, std::int64_t count) {
            for (std::int64_t k = 0; k < count; ++k, pixel += step) {
                const auto value = lines.at(goesUp ? x : x + k, goesUp ? y + k : y);
                if (lines.template areInside<rule>(value.data()))
                    *pixel = lines.pixelAt(value);
            }
        });
}

/// Adds from sample to sample and from line to line: to three edge functions, or to three weights
/// and the three levels that are their sums.
template <class Samples, StraightRule rule>
void drawIncremental(const Triangle &triangle, RawFrame frame)
{
    constexpr bool hasLevels = Samples::order == Lines::OfWeights;
    constexpr std::size_t count = hasLevels ? 6 : 3;
    using Values = std::array<typename Samples::Number, count>;
    const Samples lines(triangle, rule);
    const auto withLevels = [&](const typename Samples::Three &of) {
        Values values;
        std::copy_n(of.begin(), 3, values.begin());
        if constexpr (hasLevels) {
            for (std::size_t i = 0; i < 3; ++i)
                values[3 + i] = lines.sum(of.data(), i);
        }
        return values;
    };
    const auto add = [](Values &values, const Values &rates) {
        for (std::size_t i = 0; i < count; ++i)
            values[i] = values[i] + rates[i];
    };
    const Values perColumn = withLevels(lines.perColumn()), perRow = withLevels(lines.perRow());
    std::optional<Values> start;
    forEachLine<Samples::order>(triangle, frame,
                                [&](std::int64_t x, std::int64_t y, QRgb *pixel,
                                    std::ptrdiff_t step, std::int64_t samples) {
                                    if (start)
                                        add(*start, hasLevels ? perColumn : perRow);
                                    else
                                        start = withLevels(lines.at(x, y));
                                    Values value = *start;
                                    const Values rates = hasLevels ? perRow : perColumn;
                                    for (std::int64_t k = 0; k < samples; ++k, pixel += step) {
                                        if (lines.template areInside<rule>(value.data())) {
                                            if constexpr (hasLevels)
                                                *pixel = lines.pixel(value[3], value[4], value[5]);
                                            else
                                                *pixel = lines.pixelAt(value);
                                        }
                                        add(value, rates);
                                    }
                                });
}

using enum StraightRule;

template <class Samples>
constexpr StraightLoop evaluated(const char *method, Arithmetic arithmetic)
{
    return {method, arithmetic, SpanAxis::Column, drawEvaluated<Samples, Closed>,
            drawEvaluated<Samples, HalfOpen>};
}

template <class Samples>
constexpr StraightLoop incremental(const char *method, Arithmetic arithmetic)
{
    return {method, arithmetic, SpanAxis::Column, drawIncremental<Samples, Closed>,
            drawIncremental<Samples, HalfOpen>};
}

using ExactEdges = ExactLines<Lines::OfEdges>;
using ExactWeights = ExactLines<Lines::OfWeights>;

constexpr StraightLoop rows[] = {
    evaluated<FloatEdges<float>>("edge-equations", Arithmetic::Float32),
    evaluated<FloatEdges<double>>("edge-equations", Arithmetic::Float64),
    incremental<FloatEdges<float>>("edge-equations-incremental", Arithmetic::Float32),
    incremental<FloatEdges<double>>("edge-equations-incremental", Arithmetic::Float64),
    evaluated<FloatWeightsUpToOne<float>>("barycentric-rectangle", Arithmetic::Float32),
    evaluated<FloatWeightsUpToOne<double>>("barycentric-rectangle", Arithmetic::Float64),
    incremental<FloatWeights<float>>("barycentric-incremental", Arithmetic::Float32),
    incremental<FloatWeights<double>>("barycentric-incremental", Arithmetic::Float64),
    evaluated<FloatRelative<float>>("barycentric-relative", Arithmetic::Float32),
    evaluated<FloatRelative<double>>("barycentric-relative", Arithmetic::Float64),
    evaluated<ExactEdges>("edge-equations", Arithmetic::Exact),
    incremental<ExactEdges>("edge-equations-incremental", Arithmetic::Exact),
    evaluated<ExactWeights>("barycentric-rectangle", Arithmetic::Exact),
    incremental<ExactWeights>("barycentric-incremental", Arithmetic::Exact),
    evaluated<ExactWeights>("barycentric-relative", Arithmetic::Exact),
};

} // namespace

std::span<const StraightLoop> straightSamples() { return rows; }

} // namespace pixelplumb
