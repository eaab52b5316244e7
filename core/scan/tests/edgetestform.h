// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/tests/edgeline.h"

namespace pixelplumb {

/// Whether numbers are computed anew for each sample or by increments.
enum class Evaluation { EverySample, Increments };

/// What makes a sample inside. Every test but the first divides each edge's value by its value at
/// the opposite vertex, which gives the weight of that vertex. Signs: Scan Conversion slides, "Edge
/// Equations: Code". UnitInterval and NonNegative: Triangles slides, "Optimizations?" before and
/// after. Cramer: Rasterization slides, "Cramer's Rule".
enum class InsideTest {
    Signs, ///< E₀, E₁ and E₂ not negative, their sides flipped to be positive inside
    UnitInterval, ///< α, β and γ within [0, 1]
    NonNegative, ///< α, β and γ not negative
    Cramer, ///< u ≥ 0, v ≥ 0 and u + v ≤ 1
};

/// Which samples are visited.
enum class VisitedSamples {
    BoundingBox, ///< of the vertices, clipped to the frame
    Frame,
};

/// What the outer loop runs over.
enum class LoopOrder {
    RowByRow, ///< for y, for x: as edge equations are printed
    ColumnByColumn, ///< for x, for y: as barycentric coordinates are printed
};

/// The choices in which the literal and the stable sample-testing methods differ.
struct EdgeTestForm {
    LineForm line = LineForm::Absolute;
    Evaluation evaluation = Evaluation::EverySample;
    InsideTest inside = InsideTest::Signs;
    VisitedSamples visited = VisitedSamples::BoundingBox;
    LoopOrder order = LoopOrder::RowByRow;

    constexpr bool isBarycentric() const { return inside != InsideTest::Signs; }

    friend constexpr bool operator==(const EdgeTestForm &, const EdgeTestForm &) = default;
};

// Scan Conversion slides, "Edge Equations: Code", and the form that keeps it exact.
inline constexpr EdgeTestForm edgeEquationsForm = {};
inline constexpr EdgeTestForm incrementalEdgeEquationsForm = {.evaluation = Evaluation::Increments};
inline constexpr EdgeTestForm solvedEdgeEquationsForm = {.line = LineForm::Solved};
inline constexpr EdgeTestForm canonicalEdgeEquationsForm = {.line = LineForm::CanonicalEnd};

// Triangles slides, "for all x do for all y do" to "dealing with shared triangle edges", and the
// form that keeps it exact.
inline constexpr EdgeTestForm allSamplesBarycentricForm = {.inside = InsideTest::UnitInterval,
                                                           .visited = VisitedSamples::Frame,
                                                           .order = LoopOrder::ColumnByColumn};
inline constexpr EdgeTestForm rectangleBarycentricForm
    = {.inside = InsideTest::UnitInterval, .order = LoopOrder::ColumnByColumn};
inline constexpr EdgeTestForm incrementalBarycentricForm = {.evaluation = Evaluation::Increments,
                                                            .inside = InsideTest::NonNegative,
                                                            .order = LoopOrder::ColumnByColumn};
inline constexpr EdgeTestForm cramerBarycentricForm = {.line = LineForm::CommonVertex,
                                                       .inside = InsideTest::Cramer,
                                                       .order = LoopOrder::ColumnByColumn};
inline constexpr EdgeTestForm offScreenBarycentricForm
    = {.inside = InsideTest::NonNegative, .order = LoopOrder::ColumnByColumn};
inline constexpr EdgeTestForm relativeBarycentricForm = {.line = LineForm::FirstEnd,
                                                         .inside = InsideTest::NonNegative,
                                                         .order = LoopOrder::ColumnByColumn};

} // namespace pixelplumb
