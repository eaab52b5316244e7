// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"

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
/// draws what the column scan and the row walk draw in exact arithmetic.
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

/// Goes through the triangle so. Nothing departs in one that has no area or reaches beyond 2^15 px.
void walkAs(TriangleRuns &triangle, const ProgramWalk &walk);

/// The same, to be done to any triangle.
std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk);

} // namespace pixelplumb
