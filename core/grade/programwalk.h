// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"
#include "core/grade/walkside.h"
#include "core/scan/variedscan.h"

namespace pixelplumb {

/// What is kept of a number: all, or what is left of it where it is divided or stored as a whole
/// one, in C (toward 0) or by Python's // (down).
enum class Kept { All, TowardZero, Down };
/// Which colour an edge has at its first span: of the place where it meets it, or its vertex' own.
enum class EdgeColourStart { PreStepped, OfVertex };
/// To which sample a bound of a span is taken: what the fill rule says, ⌊ ⌋, the nearest, ⌈ ⌉.
enum class EndRounding { ByRule, Down, Nearest, Up };
/// By what a span's difference of colours is divided: y_T − y_B; this and one; or the steps from
/// its first sample, which has R_B then, to its last.
enum class SpanDivisor { Height, HeightAndOne, WholeSteps };

/// Departures along an edge: from which end spans are gone through makes a difference.
inline constexpr std::array variantsAlongEdges
    = {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne,
       Variant::UnsortedColours};

/// The edge walk of the assignment as a program has it, with what is wrong in it. By default it
/// draws what the column scan and the row walk draw.
struct ProgramWalk {
    std::optional<WalkOrder> order = {}; ///< the method's, if left out
    VariantSet departures = {}; ///< beside those of the scene, which along edges are the method's
    VariantSet departuresBehindMiddle
        = {}; ///< those of the edge from the middle vertex to the last alone
    Kept slopes = Kept::All;
    Kept edgeColours = Kept::All; ///< ΔR ΔG ΔB along an edge
    Kept preSteps = Kept::All; ///< ΔR ΔG ΔB along a span, on the way from y_B to ⌈y_B⌉
    Kept steps = Kept::All; ///< the same from sample to sample
    Kept edgeLevels = Kept::All; ///< R G B along an edge, at each span that it meets
    Kept levels = Kept::All; ///< R G B along a span, at each sample
    EdgeColourStart edgeColourStart = EdgeColourStart::PreStepped;
    /// To which span the coordinate of a vertex is taken; but by the rule, an edge has its vertex'
    /// own place and colour there.
    EndRounding spans = EndRounding::ByRule;
    EndRounding first = EndRounding::ByRule;
    EndRounding last = EndRounding::ByRule;
    SpanDivisor divisor = SpanDivisor::Height;

    friend bool operator==(const ProgramWalk &, const ProgramWalk &) = default;
};

/// ⌊ ⌋, the nearest or ⌈ ⌉ of a coordinate, px; by the rule ⌈ ⌉.
constexpr std::int64_t wholePixel(Lattice coordinate, EndRounding rounding)
{
    if (rounding == EndRounding::Down)
        return floorPixel(coordinate);
    return rounding == EndRounding::Nearest ? floorPixel(coordinate + halfPixel)
                                            : ceilPixel(coordinate);
}

/// A walk with all that decides its picture.
struct WalkedProgram {
    const ProgramWalk &walk;
    VariantSet departures; ///< the walk's and the scene's
    ByteRounding rounding = ByteRounding::Nearest;
    EndRounding spans
        = EndRounding::ByRule; ///< the walk's, as seen from the end at which it begins
    WalkSide side = {};

    /// The same behind the middle vertex.
    WalkedProgram behindMiddle() const
    {
        WalkedProgram behind = *this;
        behind.departures.bits |= walk.departuresBehindMiddle.bits;
        return behind;
    }

    /// The edge along which its places are stepped, and the one along which its colours are.
    VariedScan::Edge placesOf(const Vertex &from, const Vertex &to) const
    {
        return shifted(VariedScan{departures}.edge(from, to));
    }
    VariedScan::Edge coloursOf(const Vertex &from, const Vertex &to) const
    {
        const bool isLate = walk.edgeColourStart == EdgeColourStart::OfVertex;
        return shifted(
            VariedScan{isLate ? departures.with(Variant::NoEdgePreStep) : departures}.edge(from,
                                                                                           to));
    }
    bool hasColourPreStep() const
    {
        return !departures.contains(Variant::NoColourPreStep)
            && walk.divisor != SpanDivisor::WholeSteps;
    }

private:
    /// To the span at which its first vertex is taken to be.
    VariedScan::Edge shifted(VariedScan::Edge edge) const
    {
        if (spans == EndRounding::ByRule)
            return edge;
        const Lattice from = edge.a.position.x;
        const Lattice way = wholePixel(from, spans) * unitsPerPixel - from;
        edge.a.position.x += way;
        edge.b.position.x += way;
        return edge;
    }
};

/// The samples of a span; those that are drawn lie in the frame.
struct WalkedSpan {
    std::int64_t first = 0, end = 0;
    std::int64_t firstDrawn = 0, endDrawn = 0;
};

/// Goes through the triangle so, in the scene's arithmetic, or on the triangle's side in float64.
/// Nothing departs in one that has no area or reaches beyond what the arithmetic holds, or in exact
/// arithmetic beyond 2^15 px.
void walkAs(TriangleRuns &triangle, const ProgramWalk &walk);

/// The same, to be done to any triangle.
std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk);

/// The same as a redrawing that can be done together with others.
Redrawing redrawingBy(const ProgramWalk &walk, LevelOverflow overflow);

} // namespace pixelplumb
