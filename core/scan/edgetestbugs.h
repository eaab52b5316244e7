// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

/// The mistakes of a program that tests the samples of a box against a triangle's edges, as
/// settings of the mistaken edge test (tests/mistakenedgetest.h).
namespace pixelplumb {

/// What the program tests of an edge function.
enum class EdgeQuestion : std::uint8_t { IsInside, IsOutside, Nothing };
/// What it takes for an edge function: this one, its negative, or that of the next or the previous
/// edge.
enum class EdgeValue : std::uint8_t { Own, Negated, OfNext, OfPrevious };
/// How an edge function is computed: exactly; cut toward 0 or rounded down to whole px²; with both
/// products cut; with a, b and c cut; with the products added; or in whole px² with the function,
/// or each product, kept in 16 bits.
enum class EdgeFunctionForm : std::uint8_t {
    Right,
    Cut,
    Floored,
    ProductsCut,
    CoefficientsCut,
    ProductsAdded,
    InShort,
    ProductsInShort
};
/// Where the functions are evaluated for a sample of the box: at the sample; as far along as all
/// rows before it have stepped; with x and y exchanged; or as far from (x_min, y_min) as the sample
/// is from the box' first one.
enum class TestedPlace : std::uint8_t { OfSample, NotSetBack, StepsExchanged, FromBoxCorner };
/// How far outside an edge a drawn sample may be.
enum class EdgeSlack : std::uint8_t {
    None,
    OfFunction, ///< E ≥ −1 px²
    OfHalf, ///< E > −½ px²
    OfTenth, ///< E > −0.1 px²
    OfDistance, ///< half a pixel
    OfWeight, ///< 0.01
};
/// Which edges own the samples on them: the scene's rule, or sides of the triangle; or those that
/// are top or left edges where vertices turn counter-clockwise, whichever way they turn.
enum class EdgeOwner : std::uint8_t { OfRule, BottomRight, BottomLeft, TopRight, AsGiven };
/// What happens in a row at a sample outside.
enum class OutsideSample : std::uint8_t { GoesOn, EndsRow };
/// The weight of a vertex: its own; 0; that of the next or the previous vertex; or 1 minus one of
/// the others and plus the other, or 1 minus one of them alone.
enum class WeightForm : std::uint8_t {
    Own,
    Missing,
    OfNext,
    OfPrevious,
    AddsNext,
    AddsPrevious,
    LeavesNext,
    LeavesPrevious
};
/// What edge functions are divided by: twice the area, the area, or 1 px².
enum class WeightDivisor : std::uint8_t { DoubledArea, Area, Nothing };
/// What is kept of a weight: all, or 0 and 1 alone.
enum class KeptWeight : std::uint8_t { All, Whole };
/// What happens to each product of weight and level before the three are added.
enum class WeightedProduct : std::uint8_t { AsItIs, Cut, Rounded };

/// What a program that tests edges does wrong. Each setting is one byte, 0 where it is right.
struct EdgeTestBugs {
    std::array<EdgeQuestion, 3> questions = {}; ///< of the edges 01, 12, 20
    std::array<EdgeValue, 3> values = {};
    EdgeFunctionForm function = EdgeFunctionForm::Right;
    TestedPlace place = TestedPlace::OfSample;
    EdgeSlack slack = EdgeSlack::None;
    EdgeOwner owner = EdgeOwner::OfRule;
    OutsideSample outside = OutsideSample::GoesOn;
    std::array<WeightForm, 3> weights = {}; ///< by vertex
    WeightDivisor divisor = WeightDivisor::DoubledArea;
    KeptWeight keptWeight = KeptWeight::All;
    WeightedProduct product = WeightedProduct::AsItIs;

    constexpr bool isRight() const { return *this == EdgeTestBugs(); }
    /// Whether its colours differ from those of the triangle's plane.
    constexpr bool changesColours() const
    {
        EdgeTestBugs ofCoverage;
        ofCoverage.questions = questions;
        ofCoverage.slack = slack;
        ofCoverage.owner = owner;
        ofCoverage.outside = outside;
        return *this != ofCoverage;
    }
    friend constexpr bool operator==(const EdgeTestBugs &, const EdgeTestBugs &) = default;
};

/// The bugs of a program that has both; none where they change the same setting.
constexpr std::optional<EdgeTestBugs> together(const EdgeTestBugs &one, const EdgeTestBugs &other)
{
    using Bytes = std::array<std::uint8_t, sizeof(EdgeTestBugs)>;
    auto both = std::bit_cast<Bytes>(one);
    const auto added = std::bit_cast<Bytes>(other);
    for (std::size_t place = 0; place < both.size(); ++place) {
        if (both[place] != 0 && added[place] != 0)
            return std::nullopt;
        both[place] |= added[place];
    }
    return std::bit_cast<EdgeTestBugs>(both);
}

} // namespace pixelplumb
