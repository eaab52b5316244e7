// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/tests/edgetestsetup.h"
#include "core/trace/currentstep.h"

#include <optional>

/// What the tables of edge tests read: the kernel's numbers as quantities, so that one table serves
/// every arithmetic.
namespace pixelplumb {

using ThreeQuantities = std::array<Quantity, 3>;

struct EdgeTestLineState {
    Quantity determinant; ///< of the solved form; 0 where the line passes through (0, 0)
    Quantity u, v; ///< the end point from which the form computes, px
    Quantity sign; ///< −1 after a flip, else 1
    Quantity sidedness; ///< at the vertex that faces the edge, before a flip
    Quantity a, b, c;
    Quantity atOpposite;
    /// The value at the off-screen point, and its product with atOpposite; none under other rules.
    Quantity atRulesPoint, tieProduct;

    /// Whether the solved form found no solution.
    bool passesOrigin() const { return determinant.toDouble() == 0; }
};

/// The samples of the box along one axis, tested and before they are clipped to the frame.
struct BoxExtent {
    std::int64_t first = 0, end = 0;
    std::int64_t visitedFirst = 0, visitedEnd = 0;
    BoxRounding rounding = BoxRounding::None;

    /// The sample at the frame's border where the box is clipped there.
    std::optional<std::int64_t> firstClip() const
    {
        return first == visitedFirst ? std::nullopt : std::optional(first);
    }
    std::optional<std::int64_t> lastClip() const
    {
        return end == visitedEnd ? std::nullopt : std::optional(end - 1);
    }
};

/// Along x or y.
template <class A>
BoxExtent boxExtentOf(const EdgeTestSetUp<A> &setUp, QChar axis)
{
    const SampleBox &tested = setUp.tested, &visited = setUp.visited;
    return axis == u'x'
        ? BoxExtent{tested.firstX, tested.endX, visited.firstX, visited.endX, setUp.boxRounding}
        : BoxExtent{tested.firstY, tested.endY, visited.firstY, visited.endY, setUp.boxRounding};
}

struct EdgeTestSetUpState {
    std::array<Vertex, 3> vertices;
    bool zeroArea = false;
    ThreeQuantities x, y; ///< of the vertices, px
    BoxExtent columns, rows; ///< of the box
    std::array<EdgeTestLineState, 3> lines;
    FillRule rule = FillRule::Closed;
    int down = -1; ///< the step of y that goes down on the screen
    Quantity rulesX, rulesY; ///< of the off-screen point, px; none under other rules
    std::array<bool, 3> ownsTie = {};
    Quantity xAC, yAC, xBC, yBC; ///< of Cramer's rule, px
    Quantity determinant; ///< |A − C, B − C|, px²
    ThreeQuantities weightPerX, weightPerY; ///< [line]
    ThreeQuantities colourPerX, colourPerY; ///< [channel], levels/px
};

struct EdgeTestSpanState {
    std::size_t primitive = 0;
    std::int64_t coordinate = 0;
    BoxExtent columns, rows; ///< of the whole box
    ThreeQuantities value, weight, colour; ///< at the first tested sample, where incremental
};

/// The numbers of a sample; where a segment decided, none but the colour.
struct EdgeTestSampleState {
    ThreeQuantities value, weight;
    Quantity sum; ///< u + v of Cramer's rule
    ThreeQuantities colour; ///< levels, before rounding
    bool ofSegment = false;
    bool isCovered = false;
    std::array<Vertex, 3> vertices;
    LatticePoint sample;
};

template <class A>
ThreeQuantities quantitiesIn(const std::array<typename A::Ratio, 3> &ratios)
{
    return {A::quantityOf(ratios[0]), A::quantityOf(ratios[1]), A::quantityOf(ratios[2])};
}

template <class A>
EdgeTestLineState edgeTestStateOf(const EdgeLine<A> &edge, typename A::Number atOpposite)
{
    using Number = typename A::Number;
    const auto length
        = [](Lattice units) { return A::quantityOf(A::length(units), unitsPerPixel); };
    const Number sidedness = edge.sign < 0 ? Number(0) - atOpposite : atOpposite;
    EdgeTestLineState state;
    state.determinant = A::quantityOf(edge.determinant, squareUnitsPerPixel);
    state.u = length(edge.origin.x);
    state.v = length(edge.origin.y);
    state.sign = Quantity::integer(edge.sign);
    state.sidedness = A::quantityOf(sidedness, edge.unit);
    state.a = A::quantityOfRate(edge.a, edge.unit);
    state.b = A::quantityOfRate(edge.b, edge.unit);
    state.c = A::quantityOf(edge.c, edge.unit);
    state.atOpposite = A::quantityOf(atOpposite, edge.unit);
    return state;
}

/// Adds the rule and its ties; the numbers of the off-screen point stay none under other rules.
template <class A, EdgeTestForm form>
void addTies(EdgeTestSetUpState &state, const EdgeTestSetUp<A> &setUp)
{
    state.rule = setUp.rule.rule;
    state.down = setUp.rule.down();
    state.ownsTie = setUp.ownsTie;
    if (setUp.rule.rule != FillRule::OffScreenPoint || setUp.zeroArea)
        return;
    const LatticePoint &point = setUp.rule.offScreenPoint;
    state.rulesX = A::quantityOf(A::length(point.x), unitsPerPixel);
    state.rulesY = A::quantityOf(A::length(point.y), unitsPerPixel);
    for (std::size_t i = 0; i < 3; ++i) {
        EdgeTestLineState &line = state.lines[i];
        const EdgeLine<A> &edge = setUp.lines[i];
        line.atRulesPoint = A::quantityOf(edge.template valueAt<form.line>(point), edge.unit);
        line.tieProduct = productOf(line.atOpposite, line.atRulesPoint);
    }
}

template <class A, EdgeTestForm form>
EdgeTestSetUpState edgeTestStateOf(const EdgeTestSetUp<A> &setUp)
{
    const auto length
        = [](typename A::Number number) { return A::quantityOf(number, unitsPerPixel); };
    EdgeTestSetUpState state;
    state.vertices = setUp.vertices;
    state.zeroArea = setUp.zeroArea;
    state.columns = boxExtentOf(setUp, u'x');
    state.rows = boxExtentOf(setUp, u'y');
    for (std::size_t i = 0; i < 3; ++i) {
        state.x[i] = length(A::length(setUp.vertices[i].position.x));
        state.y[i] = length(A::length(setUp.vertices[i].position.y));
        state.lines[i] = edgeTestStateOf(setUp.lines[i], setUp.atOpposite[i]);
    }
    addTies<A, form>(state, setUp);
    // In Cramer's rule A − C and B − C span the lines ca and bc.
    const typename A::Number zero(0);
    state.xAC = length(zero - setUp.lines[1].b);
    state.yAC = length(setUp.lines[1].a);
    state.xBC = length(setUp.lines[0].b);
    state.yBC = length(zero - setUp.lines[0].a);
    state.determinant = A::quantityOf(zero - setUp.atOpposite[0], squareUnitsPerPixel);
    if (setUp.zeroArea)
        return state;
    state.weightPerX = quantitiesIn<A>(setUp.weightPerX);
    state.weightPerY = quantitiesIn<A>(setUp.weightPerY);
    state.colourPerX = quantitiesIn<A>(setUp.colourPerX);
    state.colourPerY = quantitiesIn<A>(setUp.colourPerY);
    return state;
}

template <class A>
EdgeTestSpanState edgeTestStateOf(const CurrentSpan<EdgeTestSetUp<A>, EdgeTestSpan<A>> &step)
{
    const EdgeTestSpan<A> &span = step.span;
    EdgeTestSpanState state;
    state.primitive = step.primitive;
    state.coordinate = span.coordinate;
    state.columns = boxExtentOf(step.setUp, u'x');
    state.rows = boxExtentOf(step.setUp, u'y');
    if (step.setUp.zeroArea)
        return state; // no edge tests a segment
    for (std::size_t line = 0; line < 3; ++line)
        state.value[line] = A::quantityOf(span.value[line], squareUnitsPerPixel);
    state.weight = quantitiesIn<A>(span.weight);
    state.colour = quantitiesIn<A>(span.colour);
    return state;
}

/// A sample has a colour if it is covered or, where colours are stepped like weights, everywhere.
template <class A, EdgeTestForm form>
ThreeQuantities edgeTestColourOf(const TestedSample<A> &sample)
{
    constexpr bool isStepped = form.evaluation == Evaluation::Increments && form.isBarycentric();
    const bool isColoured = sample.covered || (isStepped && !sample.ofSegment);
    return isColoured ? quantitiesIn<A>(sample.colour) : ThreeQuantities();
}

template <class A, EdgeTestForm form>
EdgeTestSampleState edgeTestStateOf(
    const CurrentSample<EdgeTestSetUp<A>, EdgeTestSpan<A>, TestedSample<A>> &step)
{
    const TestedSample<A> &sample = step.sample;
    EdgeTestSampleState state;
    state.ofSegment = sample.ofSegment;
    state.isCovered = sample.covered;
    state.vertices = step.setUp.vertices;
    state.sample = latticePixel(step.x, step.y);
    state.colour = edgeTestColourOf<A, form>(sample);
    if (sample.ofSegment)
        return state;
    for (std::size_t line = 0; line < 3; ++line)
        state.value[line] = A::quantityOf(sample.value[line], step.setUp.lines[line].unit);
    state.weight = quantitiesIn<A>(sample.weight);
    if constexpr (form.inside == InsideTest::Cramer)
        state.sum = A::quantityOf(sample.weight[0] + sample.weight[1]);
    return state;
}

} // namespace pixelplumb
