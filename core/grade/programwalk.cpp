// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/programwalk.h"

#include "core/grade/exactwalk.h"
#include "core/grade/roundedwalk.h"
#include "core/grade/walking.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The triangle as seen by a program that visits spans in ascending order.
TriangleRuns seenFrom(const TriangleRuns &triangle, SpanOrder order)
{
    TriangleRuns seen = triangle;
    seen.runs.clear();
    if (order == SpanOrder::Ascending)
        return seen;
    for (Vertex &vertex : seen.triangle.vertices)
        vertex.position.x = -vertex.position.x;
    seen.firstSpan = 1 - triangle.endSpan;
    seen.endSpan = 1 - triangle.firstSpan;
    seen.intervals.columns = reversed(triangle.intervals.columns);
    return seen;
}

/// From the other end, a program does not share the method's departures along edges.
VariantSet departuresOf(const TriangleRuns &triangle, SpanOrder order)
{
    VariantSet departures = triangle.settings.variants;
    for (const Variant variant : variantsAlongEdges) {
        if (order != triangle.order)
            departures = departures.without(variant);
    }
    return departures;
}

template <class Numbers>
bool walkIn(TriangleRuns &triangle, const ProgramWalk &walk)
{
    const SpanOrder order = walk.order.value_or(triangle.order);
    TriangleRuns seen = seenFrom(triangle, order);
    const bool isHeld = std::ranges::all_of(seen.triangle.vertices, [&](const Vertex &vertex) {
        return Numbers::represents(vertex.position)
            && (!walk.remembers() || isNarrow(vertex.position));
    });
    if (!isHeld)
        return false;
    const WalkedProgram program(
        walk, departuresOf(triangle, order), triangle.settings.rounding, order,
        triangle.side ? WalkSide(seen.triangle, *triangle.side) : WalkSide());
    Walking<Numbers>(seen, program).run();
    triangle.runs = std::move(seen.runs);
    for (SampleRun &run : triangle.runs)
        run.span = order == SpanOrder::Ascending ? run.span : -run.span;
    return true;
}

/// The positions that are compared, one pair after another, and swapped where the second's x is
/// less.
std::vector<std::array<std::size_t, 2>> comparisonsOf(VertexOrder vertices)
{
    switch (vertices) {
    case VertexOrder::Compared01:
        return {{0, 1}};
    case VertexOrder::Compared12:
        return {{1, 2}};
    case VertexOrder::Compared02:
        return {{0, 2}};
    case VertexOrder::Compared01And12:
        return {{0, 1}, {1, 2}};
    case VertexOrder::Compared12And01:
        return {{1, 2}, {0, 1}};
    case VertexOrder::Compared01And02:
        return {{0, 1}, {0, 2}};
    case VertexOrder::Compared02And12:
        return {{0, 2}, {1, 2}};
    case VertexOrder::ByX:
    case VertexOrder::ByXThenAsGiven:
    case VertexOrder::ByXThenDown:
    case VertexOrder::ByY:
    case VertexOrder::AsGiven:
        break;
    }
    return {};
}

} // namespace

ProgramWalk ProgramWalk::withRightEdges() const
{
    ProgramWalk walk = *this;
    const ProgramWalk right;
    for (const Variant variant :
         {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne})
        walk.departures = walk.departures.without(variant);
    walk.slopeForm = right.slopeForm;
    walk.slopes = right.slopes;
    walk.edgeColours = right.edgeColours;
    walk.runEnds = right.runEnds;
    walk.edgePlaces = right.edgePlaces;
    walk.edgeLevels = right.edgeLevels;
    walk.placePreStep = right.placePreStep;
    walk.edgeColourPreStep = right.edgeColourPreStep;
    walk.edgeStoring = right.edgeStoring;
    walk.withoutEdgePreStep = right.withoutEdgePreStep;
    walk.unsteppedAlongEdges = right.unsteppedAlongEdges;
    walk.ratesAlongEdgesOf = right.ratesAlongEdgesOf;
    walk.stepsAlongEdgesOf = right.stepsAlongEdgesOf;
    walk.edgeColourDivisor = right.edgeColourDivisor;
    walk.edgeColourSign = right.edgeColourSign;
    return walk;
}

std::array<int, 3> vertexOrderOf(const Triangle &triangle, VertexOrder vertices)
{
    if (vertices == VertexOrder::ByX)
        return sortedByColumn(triangle);
    std::array<int, 3> order = {0, 1, 2};
    const auto placeOf = [&](int index) -> const LatticePoint & {
        return triangle.vertices[std::size_t(index)].position;
    };
    for (const auto &[first, second] : comparisonsOf(vertices)) {
        if (placeOf(order[second]).x < placeOf(order[first]).x)
            std::swap(order[first], order[second]);
    }
    if (vertices == VertexOrder::ByY)
        std::ranges::stable_sort(order, {}, [&](int index) { return placeOf(index).y; });
    const bool isByX
        = vertices == VertexOrder::ByXThenAsGiven || vertices == VertexOrder::ByXThenDown;
    if (isByX)
        std::ranges::stable_sort(order, {}, [&](int index) {
            const LatticePoint &place = placeOf(index);
            return LatticePoint{place.x, vertices == VertexOrder::ByXThenDown ? -place.y : 0};
        });
    return order;
}

bool walkAs(TriangleRuns &triangle, const ProgramWalk &walk)
{
    if (doubledArea(triangle.triangle) == 0)
        return false;
    if (triangle.side)
        return walkIn<RoundedWalk<double>>(triangle, walk);
    switch (triangle.settings.arithmetic) {
    case Arithmetic::Exact:
        return walkIn<ExactWalk>(triangle, walk);
    case Arithmetic::Float32:
        return walkIn<RoundedWalk<float>>(triangle, walk);
    case Arithmetic::Float64:
        return walkIn<RoundedWalk<double>>(triangle, walk);
    case Arithmetic::Fixed16:
        return walkIn<RoundedWalk<FixedPoint16>>(triangle, walk);
    case Arithmetic::Fixed32:
        return walkIn<RoundedWalk<FixedPoint32>>(triangle, walk);
    }
    return false;
}

std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk)
{
    return [walk](TriangleRuns &triangle) { walkAs(triangle, walk); };
}

} // namespace pixelplumb
