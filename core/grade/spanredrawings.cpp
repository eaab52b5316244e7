// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/spanredrawings.h"

#include "core/oracle/oracle.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const LatticePoint &sortedVertex(const Triangle &triangle, std::size_t place)
{
    const auto order = sortedByColumn(triangle);
    return triangle.vertices[std::size_t(order[place])].position;
}

std::int64_t floorOf(const Quantity &quantity)
{
    return std::int64_t(floorDivide(quantity.numerator(), quantity.denominator()));
}

std::int64_t ceilOf(const Quantity &quantity)
{
    return std::int64_t(ceilDivide(quantity.numerator(), quantity.denominator()));
}

/// ⌊q + ½⌋
std::int64_t nearestTo(const Quantity &quantity)
{
    return std::int64_t(
        floorDivide(2 * quantity.numerator() + quantity.denominator(), 2 * quantity.denominator()));
}

using Whole = std::int64_t (*)(const Quantity &end);

/// The levels of a span of no height: its one point's, for there is no difference to be divided.
std::optional<LevelRamp> levelsOfPoint(const oracle::ExactColumn &column)
{
    if (column.yBottom.toDouble() < column.yTop.toDouble())
        return std::nullopt;
    LevelRamp ramp;
    for (std::size_t i = 0; i < 3; ++i)
        ramp.first[i] = column.colourBottom[i].toDouble();
    return ramp;
}

/// Every span from one rounding of its lower bound to one of its upper bound, those of no height
/// among them.
void roundEnds(TriangleRuns &triangle, Whole first, Whole last)
{
    const std::int64_t left
        = std::max(ceilPixel(sortedVertex(triangle.triangle, 0).x), triangle.firstSpan);
    const std::int64_t right
        = std::min(floorPixel(sortedVertex(triangle.triangle, 2).x), triangle.endSpan - 1);
    triangle.runs.clear();
    for (std::int64_t span = left; span <= right; ++span) {
        const auto column = oracle::columnAt(triangle.triangle, FillRule::Closed, span);
        if (column)
            triangle.runs.push_back(
                {span, first(column->yBottom), last(column->yTop) + 1, levelsOfPoint(*column)});
    }
}

/// Of a program that takes the long edge for the same bound always: where it is the other one,
/// spans end before they begin.
void omitWithMiddle(TriangleRuns &triangle, int side)
{
    const Triangle &of = triangle.triangle;
    const Int128 area = doubledArea(sortedVertex(of, 0), sortedVertex(of, 2), sortedVertex(of, 1));
    if (side > 0 ? area > 0 : area < 0)
        triangle.runs.clear();
}

/// y of an edge whose slope is cast to a whole number, in lattice units.
Lattice castEdgeAt(const LatticePoint &from, const LatticePoint &to, std::int64_t span)
{
    const Lattice slope = (to.y - from.y) / (to.x - from.x);
    return from.y + slope * (span * unitsPerPixel - from.x);
}

/// An edge at a column, whose levels are late by the way from its vertex to its first column.
struct LateEdge {
    double y = 0; ///< px
    std::array<double, 3> levels = {};
};

/// None where it runs along the column.
std::optional<LateEdge> lateEdgeAt(const Vertex &from, const Vertex &to, std::int64_t span)
{
    if (from.position.x == to.position.x)
        return std::nullopt;
    const auto pixels = [](Lattice coordinate) { return double(coordinate) / unitsPerPixel; };
    const double width = pixels(to.position.x - from.position.x);
    const double way = double(span) - pixels(from.position.x);
    const double late = double(span - ceilPixel(from.position.x));
    LateEdge edge{pixels(from.position.y) + way * pixels(to.position.y - from.position.y) / width,
                  {}};
    for (std::size_t i = 0; i < 3; ++i) {
        const int level = from.colour.channels[i];
        edge.levels[i] = level + late * (to.colour.channels[i] - level) / width;
    }
    return edge;
}

} // namespace

void truncateEnds(TriangleRuns &triangle) { roundEnds(triangle, floorOf, floorOf); }

void roundToNearest(TriangleRuns &triangle) { roundEnds(triangle, nearestTo, nearestTo); }

void roundOutward(TriangleRuns &triangle) { roundEnds(triangle, floorOf, ceilOf); }

void roundUpward(TriangleRuns &triangle) { roundEnds(triangle, ceilOf, ceilOf); }

void omitLastSamples(TriangleRuns &triangle)
{
    for (SampleRun &run : triangle.runs)
        --run.end;
}

void omitFirstSamples(TriangleRuns &triangle)
{
    for (SampleRun &run : triangle.runs)
        ++run.first;
}

void omitLastSpan(TriangleRuns &triangle)
{
    if (!triangle.runs.empty())
        triangle.runs.pop_back();
}

void omitFirstSpan(TriangleRuns &triangle)
{
    if (!triangle.runs.empty())
        triangle.runs.erase(triangle.runs.begin());
}

void omitMiddleSpan(TriangleRuns &triangle)
{
    const std::int64_t middle = ceilPixel(sortedVertex(triangle.triangle, 1).x);
    std::erase_if(triangle.runs, [&](const SampleRun &run) { return run.span == middle; });
}

void omitFirstHalf(TriangleRuns &triangle)
{
    const std::int64_t middle = ceilPixel(sortedVertex(triangle.triangle, 1).x);
    std::erase_if(triangle.runs, [&](const SampleRun &run) { return run.span < middle; });
}

void omitSecondHalf(TriangleRuns &triangle)
{
    const std::int64_t middle = ceilPixel(sortedVertex(triangle.triangle, 1).x);
    std::erase_if(triangle.runs, [&](const SampleRun &run) { return run.span >= middle; });
}

void omitWithMiddleAbove(TriangleRuns &triangle) { omitWithMiddle(triangle, 1); }

void omitWithMiddleBelow(TriangleRuns &triangle) { omitWithMiddle(triangle, -1); }

void castIncrements(TriangleRuns &triangle)
{
    for (SampleRun &run : triangle.runs) {
        const auto here = oracle::colourAt(triangle.triangle, run.span, run.first);
        const auto next = oracle::colourAt(triangle.triangle, run.span, run.first + 1);
        LevelRamp ramp;
        for (std::size_t i = 0; i < 3; ++i) {
            const Int128 numerator = next[i].numerator() * here[i].denominator()
                - here[i].numerator() * next[i].denominator();
            ramp.first[i] = here[i].toDouble();
            ramp.rate[i] = double(numerator / (next[i].denominator() * here[i].denominator()));
        }
        run.levels = ramp;
    }
}

void castSlopes(TriangleRuns &triangle)
{
    const LatticePoint &p0 = sortedVertex(triangle.triangle, 0);
    const LatticePoint &p1 = sortedVertex(triangle.triangle, 1);
    const LatticePoint &p2 = sortedVertex(triangle.triangle, 2);
    for (SampleRun &run : triangle.runs) {
        const bool isFirstHalf = run.span * unitsPerPixel < p1.x;
        if ((isFirstHalf ? p0.x == p1.x : p1.x == p2.x) || p0.x == p2.x)
            continue;
        const Lattice across = castEdgeAt(p0, p2, run.span);
        const Lattice along
            = isFirstHalf ? castEdgeAt(p0, p1, run.span) : castEdgeAt(p1, p2, run.span);
        run.first = ceilPixel(std::min(across, along));
        run.end = floorPixel(std::max(across, along)) + 1;
    }
}

void divideByHeightAndOne(TriangleRuns &triangle)
{
    for (SampleRun &run : triangle.runs) {
        const auto column = oracle::columnAt(triangle.triangle, FillRule::Closed, run.span);
        if (!column)
            continue;
        const double bottom = column->yBottom.toDouble();
        const double divisor = column->yTop.toDouble() - bottom + 1;
        LevelRamp ramp;
        for (std::size_t i = 0; i < 3; ++i) {
            const double level = column->colourBottom[i].toDouble();
            ramp.rate[i] = (column->colourTop[i].toDouble() - level) / divisor;
            ramp.first[i] = level + (double(run.first) - bottom) * ramp.rate[i];
        }
        run.levels = ramp;
    }
}

void omitColourEdgePreStep(TriangleRuns &triangle)
{
    const auto order = sortedByColumn(triangle.triangle);
    const auto vertex
        = [&](std::size_t place) { return triangle.triangle.vertices[std::size_t(order[place])]; };
    for (SampleRun &run : triangle.runs) {
        const bool isFirstHalf = run.span * unitsPerPixel < vertex(1).position.x;
        const auto across = lateEdgeAt(vertex(0), vertex(2), run.span);
        const auto along = isFirstHalf ? lateEdgeAt(vertex(0), vertex(1), run.span)
                                       : lateEdgeAt(vertex(1), vertex(2), run.span);
        if (!across || !along)
            continue;
        const LateEdge &lower = across->y < along->y ? *across : *along;
        const LateEdge &upper = across->y < along->y ? *along : *across;
        const double height = upper.y - lower.y;
        LevelRamp ramp;
        for (std::size_t i = 0; i < 3; ++i) {
            ramp.rate[i] = height > 0 ? (upper.levels[i] - lower.levels[i]) / height : 0;
            ramp.first[i] = lower.levels[i] + (double(run.first) - lower.y) * ramp.rate[i];
        }
        run.levels = ramp;
    }
}

void fillBox(TriangleRuns &triangle)
{
    if (triangle.runs.empty())
        return;
    const auto across = [](const Vertex &vertex) { return vertex.position.x; };
    const auto along = [](const Vertex &vertex) { return vertex.position.y; };
    const auto [firstSpan, lastSpan] = std::ranges::minmax(triangle.triangle.vertices, {}, across);
    const auto [first, last] = std::ranges::minmax(triangle.triangle.vertices, {}, along);
    triangle.runs.clear();
    const std::int64_t left = std::max(ceilPixel(across(firstSpan)), triangle.firstSpan);
    const std::int64_t right = std::min(floorPixel(across(lastSpan)), triangle.endSpan - 1);
    for (std::int64_t span = left; span <= right; ++span)
        triangle.runs.push_back({span, ceilPixel(along(first)), floorPixel(along(last)) + 1});
}

void omitEndOfBox(TriangleRuns &triangle)
{
    Lattice last = triangle.triangle.vertices.front().position.y;
    for (const Vertex &vertex : triangle.triangle.vertices)
        last = std::max(last, vertex.position.y);
    for (SampleRun &run : triangle.runs)
        run.end = std::min(run.end, floorPixel(last));
}

void omitLastOfBox(TriangleRuns &triangle)
{
    Lattice last = triangle.triangle.vertices.front().position.x;
    for (const Vertex &vertex : triangle.triangle.vertices)
        last = std::max(last, vertex.position.x);
    std::erase_if(triangle.runs,
                  [&](const SampleRun &run) { return run.span == floorPixel(last); });
}

} // namespace pixelplumb
