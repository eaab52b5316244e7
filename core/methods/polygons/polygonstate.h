// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/anyarithmetic.h"
#include "core/scan/polygons/polygonscan.h"
#include "core/trace/currentstep.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace pixelplumb {

/// The edge of a crossing that is shown.
struct CrossedEdge {
    LatticePoint low, high; ///< its ends of smaller and larger y
    bool begins = false; ///< the previous row does not cross it
    std::optional<std::size_t> before
        = {}; ///< its place among the crossings that the previous row shows
};

/// A row of a polygon with its numbers as quantities: what the tables of polygons read.
struct PolygonRowState {
    std::size_t primitive = 0;
    std::int64_t y = 0; ///< px
    int piece = 0; ///< index of the triangle, where the polygon is broken into them
    ShapeFill fill = ShapeFill::EvenOdd;
    std::int64_t firstDrawn = 0, endDrawn = 0; ///< inside the frame
    std::size_t crossingCount = 0; ///< active edges
    /// The crossings that are shown, the first ones; those that meet the row at the same x are in
    /// the order in which they lie below it on the screen, where its samples are taken to be.
    std::vector<Crossing<AnyArithmetic>> crossings;
    std::vector<CrossedEdge> edges; ///< of these crossings

    std::int64_t drawnSamples() const { return std::max<std::int64_t>(0, endDrawn - firstDrawn); }
};

/// A sample of a polygon with what its row says of it.
struct PolygonSampleState {
    std::int64_t crossings = 0; ///< to its left, or through it
    std::int64_t downward = 0, upward = 0; ///< of the crossings, on the screen
    std::int64_t winding = 0; ///< downward ones minus upward ones
    ShapeFill fill = ShapeFill::EvenOdd;
    bool isInside = false;
    std::vector<std::size_t> edges; ///< of those crossings, in the row's order
};

/// Orders crossings at the same x as they lie just below the row on the screen.
inline void orderBelowRow(std::vector<Crossing<AnyArithmetic>> &crossings, FrameOrigin origin)
{
    // Rows ascend upward or downward on the screen; below, x is less by the slope or more.
    const int leftmost = origin == FrameOrigin::BottomLeft ? 1 : -1;
    const auto isLeftBelow = [leftmost](const auto &a, const auto &b) {
        return leftmost * errorOf(a.slope, b.slope) > 0;
    };
    for (auto first = crossings.begin(); first != crossings.end();) {
        const auto end = std::find_if(first, crossings.end(),
                                      [&](const auto &crossing) { return crossing.x != first->x; });
        std::stable_sort(first, end, isLeftBelow);
        // NaN does not even equal itself.
        first = std::max(end, first + 1);
    }
}

/// The crossings of a row that are shown, in their order.
template <class A>
std::vector<Crossing<AnyArithmetic>> firstCrossings(const PolygonRow<A> &row, FrameOrigin origin,
                                                    std::size_t shown)
{
    std::vector<Crossing<AnyArithmetic>> crossings;
    for (const Crossing<A> &crossing : row.crossings) {
        const Quantity x = quantityOf(crossing.x);
        // Crossings at the same x as the last one shown may lie to its left.
        if (crossings.size() >= shown && x != crossings.back().x)
            break;
        crossings.push_back({crossing.edge, crossing.turn, crossing.endRow,
                             quantityOf(crossing.slope), quantityOf(crossing.base),
                             quantityOf(crossing.rise), x, crossing.firstRight});
    }
    orderBelowRow(crossings, origin);
    crossings.resize(std::min(shown, crossings.size()));
    return crossings;
}

/// The index of an edge among crossings; their count if it is not there.
template <class Crossings>
std::size_t placeOfEdge(const Crossings &crossings, std::size_t edge)
{
    const auto found
        = std::ranges::find_if(crossings, [edge](const auto &each) { return each.edge == edge; });
    return std::size_t(found - crossings.begin());
}

template <class A>
PolygonRowState polygonStateOf(const CurrentSpan<PolygonSetUp, PolygonRow<A>> &step,
                               std::size_t shown)
{
    const PolygonRow<A> &row = step.span;
    const FrameOrigin origin = step.setUp.origin;
    PolygonRowState state;
    state.primitive = step.primitive;
    state.y = row.y;
    state.piece = row.piece;
    state.fill = step.setUp.fill;
    state.firstDrawn = row.firstDrawn;
    state.endDrawn = row.endDrawn;
    state.crossingCount = row.crossings.size();
    state.crossings = firstCrossings(row, origin, shown);
    const bool continues = step.previous && step.previous->piece == row.piece;
    const auto before = continues ? firstCrossings(*step.previous, origin, shown)
                                  : std::vector<Crossing<AnyArithmetic>>();
    for (const Crossing<AnyArithmetic> &crossing : state.crossings) {
        const ContourEdge &edge = (*step.setUp.edges)[3 * std::size_t(row.piece) + crossing.edge];
        CrossedEdge &crossed = state.edges.emplace_back(CrossedEdge{edge.from, edge.to});
        if (crossed.low.y > crossed.high.y)
            std::swap(crossed.low, crossed.high);
        crossed.begins = !continues
            || placeOfEdge(step.previous->crossings, crossing.edge)
                == step.previous->crossings.size();
        const std::size_t place = placeOfEdge(before, crossing.edge);
        if (place < before.size())
            crossed.before = place;
    }
    return state;
}

template <class A>
PolygonSampleState polygonStateOf(
    const CurrentSample<PolygonSetUp, PolygonRow<A>, PolygonSample> &step)
{
    PolygonSampleState state;
    state.crossings = step.sample.crossings;
    state.winding = step.sample.winding;
    state.fill = step.setUp.fill;
    state.isInside = step.fate == SampleFate::Written;
    for (const Crossing<A> &crossing : step.span.crossings) {
        if (crossing.firstRight > step.x) {
            // All later ones are as far right, except those whose x is NaN, which come first.
            if (crossing.x == crossing.x)
                break;
            continue;
        }
        ++(crossing.turn > 0 ? state.downward : state.upward);
        state.edges.push_back(crossing.edge);
    }
    return state;
}

} // namespace pixelplumb
