// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

namespace pixelplumb {

/// The colour of an edge where it meets the current column.
template <class A>
struct EdgeColours {
    std::array<typename A::Number, 3> colour; ///< levels
    std::array<typename A::Number, 3> colourRate; ///< levels per column

    template <class Run>
    [[gnu::always_inline]] void start(const Vertex &a, const Vertex &b, const Run &run)
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            colourRate[channel] = A::edgeColourRate(a, b, channel);
            colour[channel] = A::edgeColour(a, b, channel, run, colourRate[channel]);
        }
    }

    void stepToNextColumn()
    {
        for (std::size_t channel = 0; channel < 3; ++channel)
            A::advance(colour[channel], colourRate[channel]);
    }
    void showAt(std::array<typename A::Number, 3> &bound) const { bound = colour; }
};

/// Replaces EdgeColours where nobody reads them: columns take colours from the triangle's plane.
template <class A>
struct NoEdgeColours {
    template <class Run>
    void start(const Vertex &, const Vertex &, const Run &)
    {
    }
    void stepToNextColumn() { }
    void showAt(const std::array<typename A::Number, 3> &) const { }
};

/// One edge during the walk: y and the colour where it meets the current column.
template <class A, class Colours = EdgeColours<A>>
struct EdgeWalker : Colours {
    typename A::Number y;
    typename A::Number slope; ///< px per column

    /// The edge from a to b where it meets a column: at a itself, or after a pre-step when a lies
    /// between columns or outside the frame. A jump costs no more than a step.
    [[gnu::always_inline]] EdgeWalker(const Vertex &a, const Vertex &b, std::int64_t column)
        : slope(A::edgeSlope(a, b))
    {
        const auto run = A::runTo(column, a);
        y = A::edgeOrdinate(a, b, run, slope);
        Colours::start(a, b, run);
    }

    void stepToNextColumn()
    {
        A::advance(y, slope);
        Colours::stepToNextColumn();
    }
};

} // namespace pixelplumb
