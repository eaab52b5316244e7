// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/walkedprogram.h"

namespace pixelplumb {

/// The indices of the vertices that serve as P₀ P₁ P₂.
std::array<int, 3> vertexOrderOf(const Triangle &triangle, VertexOrder vertices);

/// A triangle's P₀ P₁ P₂ as a program chooses them, with the three edges.
class WalkCorners {
public:
    WalkCorners(const Triangle &triangle, const WalkedProgram &program)
        : m_program(program)
        , m_order(vertexOrderOf(triangle, program.bugs().vertices))
        , m_triangle(program.bugs().vertexColours == VertexColours::AsGiven
                         ? withUnsortedColours(triangle, m_order)
                         : triangle)
    {
    }

    const std::array<int, 3> &order() const { return m_order; }
    const Vertex &p0() const { return vertex(0); }
    const Vertex &p1() const { return vertex(1); }
    const Vertex &p2() const { return vertex(2); }

    bool areSorted() const
    {
        return p0().position.x <= p1().position.x && p1().position.x <= p2().position.x;
    }
    /// Without a first half there is nothing to carry on: L₁₂ begins as it should.
    bool hasFirstHalf() const { return p0().position.x != p1().position.x; }

    /// m₀₁ ≤ m₀₂, with slope 0 for an edge along the spans.
    bool isFirstEdgeFlatter() const
    {
        const Lattice run = p1().position.x - p0().position.x;
        const Lattice rise = run == 0 ? 0 : p1().position.y - p0().position.y;
        const Lattice ofLong = p2().position.x - p0().position.x;
        const Lattice riseOfLong = ofLong == 0 ? 0 : p2().position.y - p0().position.y;
        return Int128(rise) * std::max<Lattice>(ofLong, 1)
            <= Int128(riseOfLong) * std::max<Lattice>(run, 1);
    }

    WalkedEdge firstEdge() const
    {
        const ScanBugs &bugs = m_program.bugs();
        return withTakenSlope(0, rated(ownFirstEdge(), bugs.firstSlope, bugs.firstColourRates));
    }
    WalkedEdge secondEdge() const
    {
        const ScanBugs &bugs = m_program.bugs();
        return withTakenSlope(
            1,
            rated(ownSecondEdge(), ofSecond(bugs.secondSlope), ofSecond(bugs.secondColourRates)));
    }
    WalkedEdge longEdge() const
    {
        const ScanBugs &bugs = m_program.bugs();
        return withTakenSlope(2, rated(ownLongEdge(), bugs.longSlope, bugs.longColourRates));
    }
    /// L₀₂ with its own value at P₁ used for the first span after P₁.
    WalkedEdge longEdgeWithoutPreStep() const
    {
        const Lattice middle = p1().position.x;
        const Lattice late = ceilPixel(middle) * unitsPerPixel - middle;
        WalkedEdge edge = longEdge();
        edge.firstPlace.position.x += late;
        edge.firstColour.position.x += late;
        return edge;
    }

private:
    const Vertex &vertex(std::size_t place) const
    {
        return m_triangle.vertices[std::size_t(m_order[place])];
    }
    WalkedEdge ownFirstEdge() const { return m_program.edge(WalkedEdges::First, p0(), p1()); }
    WalkedEdge ownSecondEdge() const { return m_program.edge(WalkedEdges::Second, p1(), p2()); }
    WalkedEdge ownLongEdge() const { return m_program.edge(WalkedEdges::Long, p0(), p2()); }

    /// Without a first half L₀₁ is never computed, so L₁₂ keeps its own rate.
    RateOf ofSecond(RateOf rate) const
    {
        const bool isOfFirst
            = rate == RateOf::FirstEdge || rate == RateOf::FirstRise || rate == RateOf::FirstRun;
        return isOfFirst && !hasFirstHalf() ? RateOf::Own : rate;
    }

    /// Takes another edge's slope, if the program does, and begins where that edge does.
    WalkedEdge withTakenSlope(std::size_t place, WalkedEdge edge) const
    {
        constexpr std::array<std::array<std::size_t, 3>, 4> sources
            = {{{0, 1, 2}, {1, 0, 2}, {2, 1, 0}, {0, 2, 1}}};
        const std::size_t source = sources[std::size_t(m_program.bugs().slopesOf)][place];
        if (source != place)
            edge.places = (source == 0       ? ownFirstEdge()
                               : source == 1 ? ownSecondEdge()
                                             : ownLongEdge())
                              .places;
        return edge;
    }

    WalkedEdge rated(WalkedEdge edge, RateOf slope, RateOf colours) const
    {
        if (slope == RateOf::Own && colours == RateOf::Own)
            return edge;
        const WalkedEdge first = ownFirstEdge();
        const WalkedEdge across = ownLongEdge();
        edge.places = ratedAs(slope, edge.places, first.places, across.places);
        edge.colours = ratedAs(colours, edge.colours, first.colours, across.colours);
        return edge;
    }

    /// The vertices between which an edge's rate is computed.
    static VariedEdge ratedAs(RateOf rate, const VariedEdge &own, const VariedEdge &first,
                              const VariedEdge &across)
    {
        switch (rate) {
        case RateOf::Own:
            break;
        case RateOf::FirstEdge:
            return first;
        case RateOf::LongEdge:
            return across;
        case RateOf::FirstRise:
            return between(first, own);
        case RateOf::LongRise:
            return between(across, own);
        case RateOf::FirstRun:
            return between(own, first);
        case RateOf::LongRun:
            return between(own, across);
        }
        return own;
    }
    static VariedEdge between(VariedEdge rise, const VariedEdge &run)
    {
        rise.a.position.x = run.a.position.x;
        rise.b.position.x = run.b.position.x;
        return rise;
    }

    const WalkedProgram &m_program;
    std::array<int, 3> m_order;
    Triangle m_triangle;
};

} // namespace pixelplumb
