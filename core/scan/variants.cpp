// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/variants.h"

namespace pixelplumb {

std::string_view nameOf(Variant variant)
{
    static constexpr std::array<std::string_view, allVariants.size()> names
        = {"rounded-box",      "stay-at-zero",
           "one-step-short",   "no-colour-pre-step",
           "no-edge-pre-step", "divisor-minus-one",
           "divisor-plus-one", "unsorted-colours",
           "twice-t",          "five-t"};
    return names[std::size_t(variant)];
}

std::optional<Variant> variantNamed(std::string_view name)
{
    for (const Variant variant : allVariants) {
        if (nameOf(variant) == name)
            return variant;
    }
    return std::nullopt;
}

std::vector<Variant> variantsIn(VariantSet set)
{
    std::vector<Variant> variants;
    for (const Variant variant : allVariants) {
        if (set.contains(variant))
            variants.push_back(variant);
    }
    return variants;
}

namespace {

constexpr VariantWords roundedBox = {
    "Rounded box",
    "left = (int) (bbox[0][0] + .5), right = (int) (bbox[0][1] - .5)",
    "⌈x_min − ½⌉ … ⌊x_max − ½⌋ of pixel centres at halves",
    "Triangle Rasterization slides, “Triangle rasterization implementation guidelines”",
    "With centres at halves, samples exactly on the box's sides of least x and y are never tested; "
    "with centres on whole numbers the last column and row are not, where they are above 0 and the "
    "box ends less than half a pixel behind them. At negative coordinates (int) cuts upwards: "
    "there the first column or row of the box may be left out.",
};
constexpr VariantWords stayAtZero = {
    "p ≤ 0 stays",
    "if p_k <= 0 then draw (x_k + 1, y_k)",
    "p_k < 0",
    "Rasterization slides, “Bresenham's Line Algorithm (4/4)”",
    "Where p_k = 0 the pixel is the other one of the two: a line does not step across at a tie, "
    "but one step later than in the slides' table; of equal radii, whose whole number p = 0 is ¼ "
    "outside, the pixel is the farther one; of unequal radii p = 0 is on the curve and stays "
    "anyway: nothing changes.",
};
constexpr VariantWords oneStepShort = {
    "Δx − 1 steps",
    "perform step 4 (Δx − 1) times",
    "Δx times",
    "Rasterization slides, “Bresenham's Line Algorithm (4/4)”",
    "The pixel at the line's end of larger x, of a steep line of larger y, is missing: where two "
    "lines meet with these ends, their joint is open.",
};
constexpr VariantWords noColourPreStep = {
    "No pre-step of colour",
    "R = R_B",
    "R = R_B + (⌈y_B⌉ − y_B)·ΔR",
    "Assignment (Borst), “Smoothly shading the triangle”, which warns of it",
    "Each span starts with the colour at its bound, not with the "
    "colour at its first sample. The distance between the two varies "
    "from span to span, which shows as stripes across the gradient.",
};
constexpr VariantWords noEdgePreStep = {
    "No pre-step of edges",
    "y = y₀ at the first column",
    "y = y₀ + (⌈x₀⌉ − x₀)·m",
    "Assignment (Borst), “The Triangle Awakens”: “y₀ is the initial value”",
    "An edge that begins between two columns, or a steep line that begins between two rows, is "
    "late by the distance to the first that it meets: it misses its other end, and triangles "
    "jitter as they move. One that begins on a column of samples, a steep line on a row, does not "
    "show it.",
};
constexpr VariantWords divisorMinusOne = {
    "Increments by Δ − 1",
    "m = Δy/(Δx − 1)",
    "m = Δy/Δx",
    "own; a count of pixels taken for one of steps, as in the Rasterization slides' “(Δx − 1) "
    "times”",
    "Increments are too large: an edge reaches its other end a pixel early and runs past it, and "
    "its colour leaves the vertices' range. Where Δ − 1 is not above 0 nothing is divided: what is "
    "so short keeps its first value.",
};
constexpr VariantWords divisorPlusOne = {
    "Increments by Δ + 1",
    "m = Δy/(Δx + 1)",
    "m = Δy/Δx",
    "own; “n + 1 pixels” taken for the number of steps, seen as gaps between neighbours in "
    "students' renderers",
    "Increments are too small: an edge does not reach its other end, nor its colour; gaps between "
    "neighbours, and a step where the other edge takes over.",
};
constexpr VariantWords unsortedColours = {
    "Colours not sorted",
    "sort (x₀, y₀), (x₁, y₁), (x₂, y₂) by x; R₀, R₁, R₂ as given",
    "colours sorted with their vertices",
    "own; the Assignment (Borst) asks for “corrected order” of the vertices",
    "The shape is right and colours stand at the wrong vertices wherever the vertices were not "
    "given in order.",
};

constexpr VariantWords twiceT = {
    "P(2t)",
    "P(t) = P₀ + 2t(P₁ − P₀), t from 0 to ½",
    "P(t) = P₀ + t(P₁ − P₀), t from 0 to 1",
    "Scan Conversion slides, “Lines and Curves: Parametric”: “not unique!”",
    "It is the same line, in half the steps: with the step of t left as it is, points stand two "
    "pixels apart, and every second pixel is missing.",
};
constexpr VariantWords fiveT = {
    "P(5t)",
    "P(t) = P₀ + 5t(P₁ − P₀), t from 0 to ⅕",
    "P(t) = P₀ + t(P₁ − P₀), t from 0 to 1",
    "Scan Conversion slides, “Lines and Curves: Parametric”: “could replace t by 5t”",
    "It is the same line, in a fifth of the steps: with the step of t left as it is, points stand "
    "five pixels apart, or a little less, and up to four pixels between them are missing.",
};

constexpr VariantWords noColourPreStepInRows = {
    noColourPreStep.title, "R = R_L", "R = R_L + (⌈x_L⌉ − x_L)·ΔR", noColourPreStep.source,
    noColourPreStep.fault,
};
constexpr VariantWords noEdgePreStepInRows = {
    noEdgePreStep.title,
    "x = x₀ at the first row",
    "x = x₀ + (y₀ − ⌊y₀⌋)·m",
    "own; the Assignment's “y₀ is the initial value”, by rows",
    "An edge that begins between two rows is late by the distance to the first that it meets: it "
    "misses its other end, and triangles jitter as they move. One that begins on a row of samples "
    "does not show it.",
};
constexpr VariantWords divisorMinusOneInRows = {
    divisorMinusOne.title,  "m = Δx/(|Δy| − 1)",   "m = Δx/|Δy|",
    divisorMinusOne.source, divisorMinusOne.fault,
};
constexpr VariantWords divisorPlusOneInRows = {
    divisorPlusOne.title,  "m = Δx/(|Δy| + 1)",  "m = Δx/|Δy|",
    divisorPlusOne.source, divisorPlusOne.fault,
};
constexpr VariantWords unsortedColoursInRows = {
    unsortedColours.title, "sort (x₀, y₀), (x₁, y₁), (x₂, y₂) by y; R₀, R₁, R₂ as given",
    unsortedColours.right, unsortedColours.source,
    unsortedColours.fault,
};

/// Null where rows need no words of their own.
const VariantWords *wordsInRows(Variant variant)
{
    switch (variant) {
    case Variant::NoColourPreStep:
        return &noColourPreStepInRows;
    case Variant::NoEdgePreStep:
        return &noEdgePreStepInRows;
    case Variant::DivisorMinusOne:
        return &divisorMinusOneInRows;
    case Variant::DivisorPlusOne:
        return &divisorPlusOneInRows;
    case Variant::UnsortedColours:
        return &unsortedColoursInRows;
    case Variant::RoundedBox:
    case Variant::StayAtZero:
    case Variant::OneStepShort:
    case Variant::TwiceT:
    case Variant::FiveT:
        break;
    }
    return nullptr;
}

} // namespace

const VariantWords &wordsOf(Variant variant, SpanAxis axis)
{
    const VariantWords *inRows = axis == SpanAxis::Row ? wordsInRows(variant) : nullptr;
    if (inRows)
        return *inRows;
    static constexpr std::array<const VariantWords *, allVariants.size()> words
        = {&roundedBox,      &stayAtZero,     &oneStepShort,    &noColourPreStep, &noEdgePreStep,
           &divisorMinusOne, &divisorPlusOne, &unsortedColours, &twiceT,          &fiveT};
    return *words[std::size_t(variant)];
}

} // namespace pixelplumb
