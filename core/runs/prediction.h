// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"

#include <QString>

#include <vector>

namespace pixelplumb {

struct TracedScene;

/// A number of the next column, row or step, which a student is to foretell.
struct Prediction {
    QString place; ///< "Column 31, second half"
    QString title; ///< "y_B", "⌈y_B⌉"
    QString words; ///< what is asked for: "y_B", "the first row, ⌈y_B⌉"
    Quantity value; ///< what the kernel computes
    /// The same number one span earlier; none where the primitive's part begins.
    Quantity earlier;
    QString rule; ///< the formula: "y_B ← y_B′ + m₀₂"
    QString reason; ///< the formula with its numbers: "y_B ← y_B′ + m₀₂ = (8 10/27) + (7/54)"
    /// What it would be without rounding; none where there is nothing to compare.
    Quantity exact = {};
    std::size_t step = 0; ///< of the trace, which computes it
};

/// Whether a formula rounds: "first row = ⌈y_B⌉".
bool isRounding(const QString &rule);

/// Whether it can be nothing but a whole number: it is rounded to one, or made of whole numbers
/// without a division.
bool asksForWhole(const Prediction &prediction);

/// The numbers that the next span behind a position (0 … stepCount()) computes by formulas, as the
/// explanation of that step has them, but for what counts the spans, what is taken over from the
/// span before under another name, and what never changes along the primitive (ΔR of a triangle),
/// which the first span alone that has it asks for; empty where no span follows.
std::vector<Prediction> predictionsAfter(const TracedScene &traced, std::size_t position);

enum class Guess {
    Right,
    Unread, ///< no number
    Earlier, ///< the value of the span before
    OtherSign,
    RoundedUp, ///< a whole number where the number itself is asked for
    RoundedDown,
    Unrounded, ///< a fraction beside a number that is rounded
    OneOff, ///< a whole number beside the right one
    Near, ///< the value with too few decimals, or cut off behind them
    Wrong,
};
/// A decimal with as many places counts when it is the value rounded to them.
constexpr int leastPlaces = 2;
/// What was typed: "9", "-8.63", "-8,63", "53/2", "8 10/27". All but decimals must be the value or
/// what it would be without rounding; of a floating-point value, to its last places.
Guess judge(const Prediction &prediction, const QString &typed);

/// Whether it is the number, told in a form that says too little: no try is lost.
constexpr bool asksForAnotherForm(Guess guess) { return guess == Guess::Near; }

} // namespace pixelplumb
