// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"

/// What programs do wrong to the spans of a triangle, as changes of the right ones.
namespace pixelplumb {

// Both ends of each span, from the exact bounds.
void truncateEnds(TriangleRuns &triangle); ///< ⌊ ⌋ of both
void roundToNearest(TriangleRuns &triangle);
void roundOutward(TriangleRuns &triangle);
void roundUpward(TriangleRuns &triangle); ///< ⌈ ⌉ of both

// Samples and spans that are left out.
void omitFirstSamples(TriangleRuns &triangle);
void omitLastSamples(TriangleRuns &triangle);
void omitFirstSpan(TriangleRuns &triangle);
void omitLastSpan(TriangleRuns &triangle);
void omitMiddleSpan(TriangleRuns &triangle); ///< the first at or after the middle vertex
void omitFirstHalf(TriangleRuns &triangle);
void omitSecondHalf(TriangleRuns &triangle);

/// All of a triangle whose middle vertex lies on that side of the long edge: of a program that
/// takes this edge for the same bound always, spans end before they begin.
void omitWithMiddleAbove(TriangleRuns &triangle);
void omitWithMiddleBelow(TriangleRuns &triangle);

// Rates cast to whole numbers: ΔR ΔG ΔB along a span; the slopes of the edges.
void castIncrements(TriangleRuns &triangle);
void castSlopes(TriangleRuns &triangle);

// ΔR ΔG ΔB divided by the height and one; levels of the edges that begin with the vertex' own at
// the first column, whose y has its pre-step.
void divideByHeightAndOne(TriangleRuns &triangle);
void omitColourEdgePreStep(TriangleRuns &triangle);

// The bounding box: drawn whole; its last sample of each span, or its last span, not.
void fillBox(TriangleRuns &triangle);
void omitEndOfBox(TriangleRuns &triangle);
void omitLastOfBox(TriangleRuns &triangle);

} // namespace pixelplumb
