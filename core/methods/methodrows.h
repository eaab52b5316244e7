// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

/// The rows of the table of methods, each made in a file of its room.
namespace pixelplumb {

// Walks along edges: the assignment's column scan, row edge walking, and stable forms of both.
Method columnScanMethod();
Method rowWalkMethod();
Method biasColumnScanMethod();
Method constantRateColumnScanMethod();
Method constantRateRowWalkMethod();
/// The outline by the midpoint algorithm, filled between its lowest and highest pixels.
Method outlineFillMethod();

// Tests of samples, in the slides' forms and in stable ones.
Method edgeEquationsMethod();
Method incrementalEdgeEquationsMethod();
Method solvedEdgeEquationsMethod();
Method canonicalEdgeEquationsMethod();
Method allSamplesBarycentricMethod();
Method rectangleBarycentricMethod();
Method incrementalBarycentricMethod();
Method cramerBarycentricMethod();
Method offScreenBarycentricMethod();
Method relativeBarycentricMethod();

// Colour, depth, texture coordinates and normals over a triangle, in the three forms of the Scan
// Conversion slides, "Interpolation During Scan Conversion". The picture shows the colour; a trace
// also carries the triangles' other attributes.
Method bilinearInterpolationMethod();
Method bilinearRowsInterpolationMethod();
Method planeInterpolationMethod();
Method barycentricInterpolationMethod();

/// y = m·x + b for each column, taken literally.
Method lineSlopeInterceptMethod();
/// P(t) = P₀ + t·(P₁ − P₀).
Method lineParametricMethod();
/// The digital differential analyzer.
Method lineDdaMethod();
/// Bresenham's line in all octants.
Method lineBresenhamMethod();
/// Bresenham's line with a tie rule that ignores directions.
Method lineSymmetricMethod();
/// Lines, circles, ellipses and Bézier curves one pixel wide: the method that antialiases them.
Method strokeCoverageMethod();

/// y = ±√(r² − x²) for each column.
Method circleExplicitMethod();
/// (r·cos θ, r·sin θ) in steps of 1/r.
Method circleParametricMethod();
/// The midpoint circle and ellipse.
Method circleMidpointMethod();
/// Filled circles and ellipses by spans.
Method circleFillMethod();
/// Bézier curves by recursive subdivision.
Method bezierSubdivisionMethod();
/// A closed path of Bézier pieces, filled by parity or winding number along its chords.
Method bezierFillMethod();

/// General scan conversion by parity, with an edge table and active edges.
Method polygonParityMethod();
/// Any polygon, broken into triangles with vertices where its edges cross.
Method polygonTessellationMethod();
/// The edges of a polygon as lines.
Method polygonOutlineMethod();
/// A convex polygon as a fan of triangles.
Method polygonFanMethod();
/// Any polygon that does not cross itself, broken into triangles by a constrained Delaunay
/// triangulation.
Method polygonDelaunayMethod();

/// Points by their address.
Method pointAddressMethod();
/// A text as the outlines of its glyphs, filled as a polygon.
Method textOutlinesMethod();

} // namespace pixelplumb
