// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/spanaxis.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace pixelplumb {

/// A departure from the correct algorithm, as a text prints it or as programs get it wrong. It is a
/// parameter of the ordinary kernels: all else in the run stays the same, so that the picture shows
/// what this one line does. The slides' E > 0 is not a variant but the fill rule Open.
enum class Variant : std::uint8_t {
    RoundedBox, ///< the box of samples is (int)(x_min + ½) … (int)(x_max − ½), as printed
    StayAtZero, ///< a decision p = 0 stays: p ≤ 0 in place of p < 0
    OneStepShort, ///< Bresenham's step 4 is done Δx − 1 times
    NoColourPreStep, ///< a span's first sample takes the edge's colour as it is
    NoEdgePreStep, ///< an edge starts at its first column or row with its vertex's values
    DivisorMinusOne, ///< increments along an edge or line are divided by Δ − 1
    DivisorPlusOne, ///< by Δ + 1
    UnsortedColours, ///< vertices are sorted, colours stay in the order given
    TwiceT, ///< P(2t) in place of P(t): "not unique", the same line in half the steps
    FiveT, ///< P(5t)
};

inline constexpr std::array allVariants = {Variant::RoundedBox,     Variant::StayAtZero,
                                           Variant::OneStepShort,   Variant::NoColourPreStep,
                                           Variant::NoEdgePreStep,  Variant::DivisorMinusOne,
                                           Variant::DivisorPlusOne, Variant::UnsortedColours,
                                           Variant::TwiceT,         Variant::FiveT};

/// Any combination of them; by default none, which is the correct algorithm.
struct VariantSet {
    std::uint32_t bits = 0; ///< 1 << the variant

    constexpr bool isEmpty() const { return bits == 0; }
    constexpr bool contains(Variant variant) const { return (bits >> int(variant) & 1U) != 0; }
    constexpr VariantSet with(Variant variant) const
    {
        return {bits | std::uint32_t(1) << int(variant)};
    }
    constexpr VariantSet without(Variant variant) const
    {
        return {bits & ~(std::uint32_t(1) << int(variant))};
    }

    friend constexpr bool operator==(const VariantSet &, const VariantSet &) = default;
};

/// The members of a set, in the order of allVariants.
std::vector<Variant> variantsIn(VariantSet set);

/// How a variant is described to the user.
struct VariantWords {
    std::string_view title; ///< "Rounded box"
    std::string_view printed; ///< the line in question
    std::string_view right; ///< the correct line
    std::string_view source; ///< where it is printed or seen, as resources/sources.md names it
    std::string_view fault; ///< what it does to the picture: a sentence
};

/// The names in files and on the command line: "rounded-box", …
std::string_view nameOf(Variant variant);
std::optional<Variant> variantNamed(std::string_view name);
/// The words for a method that fills triangles along this axis; Free, which fills none, gets those
/// for columns.
const VariantWords &wordsOf(Variant variant, SpanAxis axis);

} // namespace pixelplumb
