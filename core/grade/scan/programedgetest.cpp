// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/programedgetest.h"

#include "core/grade/scan/planelevels.h"
#include "core/scan/tests/mistakenedgetest.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

std::optional<EdgeTestSide> sideOf(const TriangleRuns &runs, const Triangle &triangle)
{
    if (!runs.side)
        return std::nullopt;
    EdgeTestSide side{0, 0, runs.side->isOutward, runs.side->isUpward};
    if (runs.side->arithmetic != Arithmetic::Exact) {
        const ArithmeticBound bound = boundOn(*runs.side, triangle);
        side.functionError = bound.functionError() * double(squareUnitsPerPixel);
        side.weightError = 16 * bound.unit();
    }
    return side;
}

WholeLevels levelsOf(const MistakenEdgeTest &program, const EdgeFunctions &functions,
                     const TriangleRuns &runs)
{
    const VertexWeights weights = program.weightsOf(functions);
    const bool isNearest = runs.settings.rounding == ByteRounding::Nearest;
    WholeLevels levels;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (runs.side) {
            const double level = program.levelOnSide(weights, channel);
            levels[channel] = std::int64_t(std::floor(level + (isNearest ? 0.5 : 0)));
        } else {
            const CommonFraction level = program.levelOf(weights, channel);
            levels[channel] = std::int64_t(isNearest ? level.nearest() : level.floor());
        }
    }
    return levels;
}

void appendRow(const MistakenEdgeTest &program, const EdgeTestBugs &bugs, std::int64_t y,
               const TriangleRuns &triangle, std::vector<SampleRun> &result)
{
    std::optional<SampleRun> run;
    const std::int64_t end = std::min(program.endOfRow(y), triangle.endSample);
    for (std::int64_t x = std::max(triangle.visited.firstX, triangle.firstSample); x < end; ++x) {
        const EdgeFunctions functions = program.functionsAt(x, y);
        if (!program.isInside(functions)) {
            if (run)
                result.push_back(*std::move(run));
            run.reset();
            continue;
        }
        if (!run)
            run = SampleRun{y, x, x, {}, x};
        run->end = x + 1;
        if (bugs.changesColours())
            run->levels.push_back(levelsOf(program, functions, triangle));
    }
    if (run)
        result.push_back(*std::move(run));
}

void testAs(const EdgeTestBugs &bugs, TriangleRuns &triangle)
{
    if (doubledArea(triangle.triangle) == 0) { // without area there are no weights
        triangle.readRight();
        return;
    }
    const Triangle asGiven = exchanged(triangle.triangle);
    const MistakenEdgeTest program(bugs, asGiven, triangle.rule, triangle.visited,
                                   sideOf(triangle, asGiven));
    triangle.runs.clear();
    if (!program.hasArea())
        return;
    for (std::int64_t y = std::max(triangle.visited.firstY, triangle.firstSpan);
         y < std::min(triangle.visited.endY, triangle.endSpan); ++y) {
        if (triangle.isAskedFor(y))
            appendRow(program, bugs, y, triangle, triangle.runs);
    }
}

} // namespace

Redrawing redrawingByTests(const EdgeTestBugs &bugs)
{
    Redrawing redrawing{[bugs](TriangleRuns &triangle) { testAs(bugs, triangle); }};
    redrawing.findsSamples = true;
    redrawing.edgeTest = std::make_shared<const EdgeTestBugs>(bugs);
    return redrawing;
}

} // namespace pixelplumb
