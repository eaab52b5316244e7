// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"
#include "core/scan/variedscan.h"

namespace pixelplumb {

/// How a division comes out: as it is, or cut toward 0, as that of two whole numbers in C is.
enum class Quotient { Exact, Whole };
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
    Quotient slopes = Quotient::Exact;
    Quotient edgeColours = Quotient::Exact; ///< ΔR ΔG ΔB along an edge
    Quotient preSteps = Quotient::Exact; ///< ΔR ΔG ΔB along a span, on the way from y_B to ⌈y_B⌉
    Quotient steps = Quotient::Exact; ///< the same from sample to sample
    EdgeColourStart edgeColourStart = EdgeColourStart::PreStepped;
    EndRounding first = EndRounding::ByRule;
    EndRounding last = EndRounding::ByRule;
    SpanDivisor divisor = SpanDivisor::Height;
};

/// A walk with all that decides its picture.
struct WalkedProgram {
    const ProgramWalk &walk;
    VariantSet departures; ///< the walk's and the scene's
    ByteRounding rounding = ByteRounding::Nearest;

    /// The edge along which its places are stepped, and the one along which its colours are.
    VariedScan::Edge placesOf(const Vertex &from, const Vertex &to) const
    {
        return VariedScan{departures}.edge(from, to);
    }
    VariedScan::Edge coloursOf(const Vertex &from, const Vertex &to) const
    {
        const bool isLate = walk.edgeColourStart == EdgeColourStart::OfVertex;
        return VariedScan{isLate ? departures.with(Variant::NoEdgePreStep) : departures}.edge(from,
                                                                                              to);
    }
    bool hasColourPreStep() const
    {
        return !departures.contains(Variant::NoColourPreStep)
            && walk.divisor != SpanDivisor::WholeSteps;
    }
};

/// The samples of a span; those that are drawn lie in the frame.
struct WalkedSpan {
    std::int64_t first = 0, end = 0;
    std::int64_t firstDrawn = 0, endDrawn = 0;
};

/// Goes through the triangle so, in the scene's arithmetic. Nothing departs in one that has no area
/// or reaches beyond what the arithmetic holds, or in exact arithmetic beyond 2^15 px.
void walkAs(TriangleRuns &triangle, const ProgramWalk &walk);

/// The same, to be done to any triangle.
std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk);

} // namespace pixelplumb
