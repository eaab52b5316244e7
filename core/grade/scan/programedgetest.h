// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/scan/redrawing.h"

namespace pixelplumb {

/// The unit of edge functions, 1 px², in square lattice units.
inline constexpr Int128 squarePixel = Int128(unitsPerPixel) * unitsPerPixel;

/// The edge functions of a triangle at a sample, square lattice units, positive inside.
struct EdgeFunctions {
    std::array<Int128, 3> values = {}; ///< for the edges from vertex 0 to 1, 1 to 2, 2 to 0
    Int128 area = 0; ///< doubled, positive; the divisor of the weights
};

/// The weight of each vertex's colour, over one denominator.
struct VertexWeights {
    std::array<Int128, 3> numerators = {};
    Int128 denominator = 1; ///< > 0
};

/// What the program tests of an edge function.
enum class EdgeQuestion { IsInside, IsOutside, Nothing };

/// How far outside an edge a drawn sample may be.
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

/// What happens in a row at a sample outside.
enum class OutsideSample { GoesOn, EndsRow };

/// What happens to each product of weight and level before the three are added.
enum class WeightedProduct { AsItIs, Cut, Rounded };

/// A program that tests three edges at the samples of the bounding box; right by default. What it
/// does not change, colours included, is drawn as by the method.
struct ProgramEdgeTest {
    /// The position, in lattice units, where the functions are evaluated for a sample in the box;
    /// none: the sample itself.
    std::function<LatticePoint(const Triangle &triangle, const SampleBox &box,
                               const LatticePoint &sample)>
        place = {};
    /// The edge function from one vertex to another at a point; none: the usual one.
    std::function<Int128(const LatticePoint &from, const LatticePoint &to, const LatticePoint &at)>
        function = {};
    std::function<void(EdgeFunctions &functions)> change = {}; ///< for test and weights
    std::array<EdgeQuestion, 3> questions = {};
    EdgeSlack slack = EdgeSlack::None;
    EdgeOwner owner = EdgeOwner::OfRule;
    OutsideSample outside = OutsideSample::GoesOn;
    std::function<void(VertexWeights &weights)> weigh = {}; ///< changes only the colours
    WeightedProduct product = WeightedProduct::AsItIs;

    /// Whether its colours differ from those of the triangle's plane.
    bool changesColours() const
    {
        return place || function || change || weigh || product != WeightedProduct::AsItIs;
    }
};

Redrawing redrawingByTests(const ProgramEdgeTest &program, LevelOverflow overflow);

} // namespace pixelplumb
