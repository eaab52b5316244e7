// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/three.h"
#include "core/scan/tests/edgeteststate.h"

namespace pixelplumb {

/// The ends of a line of the set-up, and the vertex that faces it. Edge equations number E₀ =
/// [P₀P₁], E₁ = [P₁P₂], E₂ = [P₂P₀] (Scan Conversion slides, "Edge Equations"); barycentric
/// coordinates number by the vertex that a weight belongs to: α faces bc, β faces ca, γ faces ab
/// (Triangles slides).
struct EdgeEnds {
    std::size_t from, to, opposite;
};

constexpr EdgeEnds edgeEndsOf(const EdgeTestForm &form, std::size_t line)
{
    const std::size_t from = form.isBarycentric() ? (line + 1) % 3 : line;
    return {from, (from + 1) % 3, (from + 2) % 3};
}

template <class Number>
constexpr int signOf(Number number)
{
    return int(number > Number(0)) - int(number < Number(0));
}

/// Whether a sample exactly on a line is inside. The closed rule draws it, the open one does not;
/// the others ask to which side the rule's displacement moves it, or on which side of the line the
/// off-screen point lies.
template <class A, EdgeTestForm form>
[[gnu::always_inline]] inline bool ownsTie(const EdgeTestSetUp<A> &setUp, std::size_t line,
                                           const BoundaryRule &rule)
{
    const EdgeLine<A> &edge = setUp.lines[line];
    const int inside = signOf(setUp.atOpposite[line]);
    const int perX = inside * signOf(edge.a);
    const int perY = inside * signOf(edge.b);
    switch (rule.rule) {
    case FillRule::Closed:
        return true;
    case FillRule::HalfOpenColumn: // (+ε², +ε)
        return perY != 0 ? perY > 0 : perX > 0;
    case FillRule::TopLeft: // (+ε, ε² down): a left edge, or a top edge exactly along the row
        return perX != 0 ? perX > 0 : perY * rule.down() > 0;
    case FillRule::OffScreenPoint: // f_bc(a)·f_bc(r) > 0
        return inside * signOf(edge.template valueAt<form.line>(rule.offScreenPoint)) > 0;
    case FillRule::Open:
        return false;
    }
    return false;
}

/// A channel's level weighted from the vertices: α·R_a + β·R_b + γ·R_c.
template <class A>
typename A::Ratio weightedLevel(const EdgeTestSetUp<A> &setUp,
                                const std::array<typename A::Ratio, 3> &weight, std::size_t channel)
{
    return weight[0] * setUp.facing[0][channel] + weight[1] * setUp.facing[1][channel]
        + weight[2] * setUp.facing[2][channel];
}

/// What one step of x and of y adds to the weights and the levels.
template <class A>
[[gnu::always_inline]] inline void setIncrements(EdgeTestSetUp<A> &setUp)
{
    const typename A::Number step = A::length(unitsPerPixel);
    const auto weight = [&](const typename A::Number &change, std::size_t line) {
        return A::ratio(change * step, typename A::Divisor(setUp.atOpposite[line]));
    };
    const auto colour = [&](const std::array<typename A::Ratio, 3> &weights) {
        return threeOf([&](std::size_t channel) { return weightedLevel(setUp, weights, channel); });
    };
    setUp.weightPerX = threeOf([&](std::size_t i) { return weight(setUp.lines[i].a, i); });
    setUp.weightPerY = threeOf([&](std::size_t i) { return weight(setUp.lines[i].b, i); });
    setUp.colourPerX = colour(setUp.weightPerX);
    setUp.colourPerY = colour(setUp.weightPerY);
}

template <class A, EdgeTestForm form>
[[gnu::always_inline]] inline void setLine(EdgeTestSetUp<A> &setUp, std::size_t line,
                                           const BoundaryRule &rule)
{
    const EdgeEnds ends = edgeEndsOf(form, line);
    const auto position = [&](std::size_t vertex) { return setUp.vertices[vertex].position; };
    EdgeLine<A> &edge = setUp.lines[line];
    edge = EdgeLine<A>(form.line, position(ends.from), position(ends.to), position(2));
    setUp.facing[line] = threeOf([&](std::size_t channel) {
        return typename A::Level(setUp.vertices[ends.opposite].colour.channels[channel]);
    });
    setUp.atOpposite[line] = edge.template valueAt<form.line>(position(ends.opposite));
    if (!form.isBarycentric() && setUp.atOpposite[line] < typename A::Number(0)) {
        edge.flip();
        setUp.atOpposite[line] = typename A::Number(0) - setUp.atOpposite[line];
    }
    setUp.ownsTie[line] = ownsTie<A, form>(setUp, line, rule);
}

/// Forced inline, and without loops over the lines: a kernel's innermost numbers stay in registers
/// only if nothing indexes them.
template <class A, EdgeTestForm form>
[[gnu::always_inline]] inline EdgeTestSetUp<A> edgeTestSetUp(const Triangle &triangle,
                                                             const BoundaryRule &rule,
                                                             FrameView frame,
                                                             VariantSet variants = {})
{
    EdgeTestSetUp<A> setUp;
    setUp.vertices = triangle.vertices;
    setUp.rule = rule;
    setUp.zeroArea = doubledArea(triangle) == 0;
    setUp.visited
        = form.visited == VisitedSamples::Frame ? samplesOf(frame) : boundingBoxOf(triangle);
    // One test per triangle: the correct box costs nothing more.
    if (form.visited == VisitedSamples::BoundingBox && variants.contains(Variant::RoundedBox)) {
        const auto [least, greatest] = boundingCornersOf(triangle);
        setUp.visited = roundedSamplesIn(least, greatest, frame.pixelCentre);
        setUp.boxRounding = frame.pixelCentre == PixelCentre::Half ? BoxRounding::HalfCentres
                                                                   : BoxRounding::IntegerCentres;
    }
    setUp.tested = intersection(setUp.visited, samplesOf(frame));
    setLine<A, form>(setUp, 0, rule);
    setLine<A, form>(setUp, 1, rule);
    setLine<A, form>(setUp, 2, rule);
    if (form.isBarycentric() && form.evaluation == Evaluation::Increments && !setUp.zeroArea)
        setIncrements(setUp);
    return setUp;
}

} // namespace pixelplumb
