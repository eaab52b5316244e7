// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/scan/redrawing.h"

/// Mistakes in the spans of a triangle, as changes of the right ones.
namespace pixelplumb {

// Samples and spans that are left out. First and last follow the spans' ascending coordinate.
void omitFirstSamples(TriangleRuns &triangle);
void omitLastSamples(TriangleRuns &triangle);
void omitFirstSpan(TriangleRuns &triangle); ///< ⌈x₀⌉, with or without samples
void omitLastSpan(TriangleRuns &triangle); ///< ⌊x₂⌋
void omitSpanOfFirstVertex(TriangleRuns &triangle); ///< x₀, if whole
void omitSpanOfLastVertex(TriangleRuns &triangle);
void omitSpanOfMiddleVertex(TriangleRuns &triangle);
void omitSpanFromMiddle(TriangleRuns &triangle); ///< ⌈x₁⌉
void omitSpanToMiddle(TriangleRuns &triangle); ///< ⌊x₁⌋
void omitSpanBeforeMiddle(TriangleRuns &triangle); ///< ⌊x₁⌋, if x₁ is not whole
void omitSpanBehindMiddle(TriangleRuns &triangle); ///< ⌈x₁⌉, if x₁ is not whole
void omitFirstHalf(TriangleRuns &triangle);
void omitSecondHalf(TriangleRuns &triangle);
void omitToMiddle(TriangleRuns &triangle); ///< the first half, and a span through the middle vertex
void omitBehindMiddle(TriangleRuns &triangle); ///< the second half without this span

// Triangles with an edge along a span, before or after the others.
void omitWithFirstEdgeAlong(TriangleRuns &triangle); ///< all of it
void omitWithLastEdgeAlong(TriangleRuns &triangle); ///< all of it
void omitWithEdgeAlong(TriangleRuns &triangle); ///< all of it, whichever edge it is
void omitFirstEdgeAlong(TriangleRuns &triangle); ///< the span through it
void omitLastEdgeAlong(TriangleRuns &triangle);

void omitBetweenEnds(TriangleRuns &triangle); ///< all but a span's first and last sample

} // namespace pixelplumb
