// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/number/quantity.h"
#include "core/scan/variants.h"

namespace pixelplumb {

/// The usual limit of digits after the point of a long number.
inline constexpr int usualPlaces = 6;

/// A number inside a formula or a sentence: exact text while it is short, else decimals and "…",
/// enough of them to tell it from the nearest whole number; with minus signs, not hyphens.
QString term(const Quantity &quantity, int places = usualPlaces);

/// A term as a factor or after an operator; it may be negative or a mixed number.
QString operand(const Quantity &quantity, int places = usualPlaces);

/// How many digits after the point a sum's operands need to add up to the correct side of the whole
/// number next to the result: two more than the result itself, if it is that near.
int placesOfOperands(const Quantity &result);

/// Lattice units as pixels.
Quantity pixels(Lattice units);

/// What a variant adds to the number of steps that divides increments: " − 1", " + 1".
QString divisorChange(VariantSet variants);

/// "(9 − 1)": from one coordinate to another, px.
QString differenceText(Lattice to, Lattice from);

/// "2 (number 1, 4)", or "all": which of a pixel's 4 or 16 samples, counted from 1 in the order of
/// resources/scene-file.md; bit 0 is the first.
QString sampleNumbersText(std::uint16_t samples, int count);

/// "(26 1/2, 44)", px.
QString pointText(const LatticePoint &point);

} // namespace pixelplumb
