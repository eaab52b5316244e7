// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"

#include <QString>

#include <vector>

namespace pixelplumb {

struct TracedScene;

/// A number of the next column, row or step, for a student to predict.
struct Prediction {
    QString place; ///< "Column 31, second half"
    QString title; ///< "y_B", "⌈y_B⌉"
    QString words; ///< what is asked for: "y_B", "the first row, ⌈y_B⌉"
    Quantity value; ///< what the kernel computes
    /// The same number one span earlier; none where the primitive's part begins.
    Quantity earlier;
    QString rule; ///< the formula: "y_B ← y_B′ + m₀₂"
    QString reason; ///< the formula with its numbers: "y_B ← y_B′ + m₀₂ = (8 10/27) + (7/54)"
    /// Its value without rounding; none if there is nothing to compare.
    Quantity exact = {};
    std::size_t step = 0; ///< of the trace, which computes it
    /// Whether an earlier span of the primitive shows it: ΔR, which never changes along a triangle.
    bool isRepeated = false;
};

/// Whether a formula rounds: "first row = ⌈y_B⌉".
bool isRounding(const QString &rule);

/// Whether it must be a whole number: it is rounded to one, or made of whole numbers without a
/// division.
bool asksForWhole(const Prediction &prediction);

/// The numbers that the next span after a position (0 … stepCount()) computes by formulas, as that
/// step's explanation has them, and how many pixels it has. It leaves out what counts the spans and
/// what is copied from the previous span under another name. Empty if no span
/// follows.
std::vector<Prediction> predictionsAfter(const TracedScene &traced, std::size_t position);

enum class Guess {
    Right,
    Unread, ///< not a number
    Earlier, ///< the value of the previous span
    OtherSign,
    RoundedUp, ///< a whole number where the number itself is asked for
    RoundedDown,
    Unrounded, ///< a fraction where the number is rounded
    OneOff, ///< a whole number next to the right one
    Near, ///< the value with too few decimals, or truncated
    Wrong,
};
/// A decimal with at least this many places counts if it is the value rounded to them.
constexpr int leastPlaces = 2;
/// Judges what was typed: "9", "-8.63", "-8,63", "53/2", "8 10/27". All but decimals must be the
/// value with or without rounding; for a floating-point value, to its last places.
Guess judge(const Prediction &prediction, const QString &typed);

/// Whether the guess is the number in too vague a form: it costs no try.
constexpr bool asksForAnotherForm(Guess guess) { return guess == Guess::Near; }

} // namespace pixelplumb
