// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/spanredrawings.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const LatticePoint &sortedVertex(const Triangle &triangle, std::size_t place)
{
    const auto order = sortedByColumn(triangle);
    return triangle.vertices[std::size_t(order[place])].position;
}

/// x of a vertex, lattice units, by its rank in x.
Lattice spanOfVertex(const TriangleRuns &triangle, std::size_t place)
{
    return sortedVertex(triangle.triangle, place).x;
}

void omitSpan(TriangleRuns &triangle, std::int64_t span)
{
    std::erase_if(triangle.runs, [span](const SampleRun &run) { return run.span == span; });
}

/// Only if the vertex lies exactly on the span: spans next to it are not its own.
void omitSpanOfVertex(TriangleRuns &triangle, std::size_t place)
{
    const Lattice ofVertex = spanOfVertex(triangle, place);
    if (ceilPixel(ofVertex) == floorPixel(ofVertex))
        omitSpan(triangle, ceilPixel(ofVertex));
}

bool hasFirstEdgeAlong(const TriangleRuns &triangle)
{
    return spanOfVertex(triangle, 0) == spanOfVertex(triangle, 1);
}

bool hasLastEdgeAlong(const TriangleRuns &triangle)
{
    return spanOfVertex(triangle, 1) == spanOfVertex(triangle, 2);
}

} // namespace

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

void omitFirstSpan(TriangleRuns &triangle)
{
    omitSpan(triangle, ceilPixel(spanOfVertex(triangle, 0)));
}

void omitLastSpan(TriangleRuns &triangle)
{
    omitSpan(triangle, floorPixel(spanOfVertex(triangle, 2)));
}

void omitSpanOfFirstVertex(TriangleRuns &triangle) { omitSpanOfVertex(triangle, 0); }

void omitSpanOfMiddleVertex(TriangleRuns &triangle) { omitSpanOfVertex(triangle, 1); }

void omitSpanOfLastVertex(TriangleRuns &triangle) { omitSpanOfVertex(triangle, 2); }

void omitSpanFromMiddle(TriangleRuns &triangle)
{
    omitSpan(triangle, ceilPixel(spanOfVertex(triangle, 1)));
}

void omitSpanToMiddle(TriangleRuns &triangle)
{
    omitSpan(triangle, floorPixel(spanOfVertex(triangle, 1)));
}

void omitSpanBeforeMiddle(TriangleRuns &triangle)
{
    const Lattice middle = spanOfVertex(triangle, 1);
    if (ceilPixel(middle) != floorPixel(middle))
        omitSpan(triangle, floorPixel(middle));
}

void omitSpanBehindMiddle(TriangleRuns &triangle)
{
    const Lattice middle = spanOfVertex(triangle, 1);
    if (ceilPixel(middle) != floorPixel(middle))
        omitSpan(triangle, ceilPixel(middle));
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

void omitToMiddle(TriangleRuns &triangle)
{
    const std::int64_t middle = floorPixel(spanOfVertex(triangle, 1));
    std::erase_if(triangle.runs, [&](const SampleRun &run) { return run.span <= middle; });
}

void omitBehindMiddle(TriangleRuns &triangle)
{
    const std::int64_t middle = floorPixel(spanOfVertex(triangle, 1));
    std::erase_if(triangle.runs, [&](const SampleRun &run) { return run.span > middle; });
}

void omitWithFirstEdgeAlong(TriangleRuns &triangle)
{
    if (hasFirstEdgeAlong(triangle))
        triangle.runs.clear();
}

void omitWithLastEdgeAlong(TriangleRuns &triangle)
{
    if (hasLastEdgeAlong(triangle))
        triangle.runs.clear();
}

void omitWithEdgeAlong(TriangleRuns &triangle)
{
    omitWithFirstEdgeAlong(triangle);
    omitWithLastEdgeAlong(triangle);
}

void omitFirstEdgeAlong(TriangleRuns &triangle)
{
    if (hasFirstEdgeAlong(triangle))
        omitSpanOfVertex(triangle, 0);
}

void omitLastEdgeAlong(TriangleRuns &triangle)
{
    if (hasLastEdgeAlong(triangle))
        omitSpanOfVertex(triangle, 2);
}

void omitBetweenEnds(TriangleRuns &triangle)
{
    std::vector<SampleRun> runs;
    for (const SampleRun &run : triangle.runs) {
        SampleRun end = run;
        end.end = run.first + 1;
        runs.push_back(end);
        end = run;
        end.first = run.end - 1;
        if (end.first > run.first)
            runs.push_back(end);
    }
    triangle.runs = std::move(runs);
}

} // namespace pixelplumb
