// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/boxredrawings.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The bounding box of the right program, in which x is a column.
SampleBox rightBoxOf(const TriangleRuns &triangle)
{
    return boundingBoxOf(exchanged(triangle.triangle));
}

void omitRow(TriangleRuns &triangle, std::int64_t row)
{
    std::erase_if(triangle.runs, [row](const SampleRun &run) { return run.span == row; });
}

void omitFrom(TriangleRuns &triangle, std::int64_t endColumn)
{
    for (SampleRun &run : triangle.runs)
        run.end = std::min(run.end, endColumn);
}

void omitBefore(TriangleRuns &triangle, std::int64_t firstColumn)
{
    for (SampleRun &run : triangle.runs)
        run.first = std::max(run.first, firstColumn);
}

} // namespace

void fillBox(TriangleRuns &triangle)
{
    if (doubledArea(triangle.triangle) == 0) // has no plane of colours
        return;
    const SampleBox &box = triangle.visited;
    triangle.runs.clear();
    for (std::int64_t row = std::max(box.firstY, triangle.firstSpan);
         row < std::min(box.endY, triangle.endSpan); ++row)
        triangle.runs.push_back({row, box.firstX, box.endX});
}

void omitFirstRowOfBox(TriangleRuns &triangle) { omitRow(triangle, rightBoxOf(triangle).firstY); }

void omitLastRowOfBox(TriangleRuns &triangle) { omitRow(triangle, rightBoxOf(triangle).endY - 1); }

void omitFirstColumnOfBox(TriangleRuns &triangle)
{
    omitBefore(triangle, rightBoxOf(triangle).firstX + 1);
}

void omitLastColumnOfBox(TriangleRuns &triangle)
{
    omitFrom(triangle, rightBoxOf(triangle).endX - 1);
}

void omitGreatestOfBox(TriangleRuns &triangle)
{
    const LatticePoint greatest = boundingCornersOf(exchanged(triangle.triangle)).second;
    std::erase_if(triangle.runs,
                  [&](const SampleRun &run) { return run.span >= ceilPixel(greatest.y); });
    omitFrom(triangle, ceilPixel(greatest.x));
}

void omitBesideBoxOfEdge(TriangleRuns &triangle, std::size_t vertex)
{
    Triangle edge = triangle.triangle;
    edge.vertices[(vertex + 2) % 3] = edge.vertices[vertex];
    const SampleBox box = boundingBoxOf(exchanged(edge));
    std::erase_if(triangle.runs, [&](const SampleRun &run) {
        return run.span < box.firstY || run.span >= box.endY;
    });
    omitBefore(triangle, box.firstX);
    omitFrom(triangle, box.endX);
}

void omitOnEdge(TriangleRuns &triangle, std::size_t vertex)
{
    const LatticePoint &from = triangle.triangle.vertices[vertex].position;
    const LatticePoint &to = triangle.triangle.vertices[(vertex + 1) % 3].position;
    const auto isOnEdge = [&](std::int64_t span, std::int64_t sample) {
        return doubledArea(from, to, latticePixel(span, sample)) == 0;
    };
    for (SampleRun &run : triangle.runs) {
        while (run.first < run.end && isOnEdge(run.span, run.first))
            ++run.first;
        while (run.first < run.end && isOnEdge(run.span, run.end - 1))
            --run.end;
    }
}

} // namespace pixelplumb
