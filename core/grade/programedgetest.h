// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"

namespace pixelplumb {

/// Of edge functions, in square lattice units: px².
inline constexpr Int128 squarePixel = Int128(unitsPerPixel) * unitsPerPixel;

/// The edge functions of a triangle at a sample, square lattice units, positive inside.
struct EdgeFunctions {
    std::array<Int128, 3> values = {}; ///< of the edges from vertex 0 to 1, 1 to 2, 2 to 0
    Int128 area = 0; ///< doubled: what the weights are divided by, positive
};

/// By how much each vertex' colour counts, over one denominator.
struct VertexWeights {
    std::array<Int128, 3> numerators = {};
    Int128 denominator = 1; ///< > 0
};

/// What is asked of an edge function.
enum class EdgeQuestion { IsInside, IsOutside, Nothing };

/// How far outside an edge a sample may be that is drawn.
enum class EdgeSlack {
    None,
    OfFunction, ///< E ≥ −1 px²
    OfHalf, ///< E > −½ px²
    OfTenth, ///< E > −0.1 px²
    OfDistance, ///< half a pixel
    OfWeight, ///< 0.01
};

/// Which edges own the samples on them: the scene's rule, or sides of the triangle.
enum class EdgeOwner { OfRule, BottomRight, BottomLeft, TopRight };

/// Where a program is when the first sample of a row is outside.
enum class OutsideSample { GoesOn, EndsRow };

/// What becomes of a weight times a level before the three are added.
enum class WeightedProduct { AsItIs, Cut, Rounded };

/// A program that goes through the samples of the bounding box and tests three edges; a right one
/// as it stands. What it leaves as it is, colours among them, is what the method draws.
struct ProgramEdgeTest {
    /// Where the functions are computed, lattice units, of a sample in the box; none: at the
    /// sample.
    std::function<LatticePoint(const Triangle &triangle, const SampleBox &box,
                               const LatticePoint &sample)>
        place = {};
    /// The edge function from one vertex to another at a place; none: that of the texts.
    std::function<Int128(const LatticePoint &from, const LatticePoint &to, const LatticePoint &at)>
        function = {};
    std::function<void(EdgeFunctions &functions)> change = {}; ///< for the test and the weights
    std::array<EdgeQuestion, 3> questions = {};
    EdgeSlack slack = EdgeSlack::None;
    EdgeOwner owner = EdgeOwner::OfRule;
    OutsideSample outside = OutsideSample::GoesOn;
    std::function<void(VertexWeights &weights)> weigh = {}; ///< for the colours alone
    WeightedProduct product = WeightedProduct::AsItIs;

    /// Whether its colours are not those of the triangle's plane.
    bool changesColours() const
    {
        return place || function || change || weigh || product != WeightedProduct::AsItIs;
    }
};

Redrawing redrawingByTests(const ProgramEdgeTest &program, LevelOverflow overflow);

} // namespace pixelplumb
