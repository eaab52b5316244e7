// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// Numbers that tables show and hide together.
enum class NumberGroup {
    Position, ///< which primitive, column, row or step: what counts rows, and nothing beside
    Span, ///< bounds and covered samples
    Decision, ///< edge functions, weights, decision parameters
    EdgeColours,
    ColourRates,
    FirstColour,
};

/// What a number belongs to, where the window has a sign or a heading for that.
enum class NumberSubject { General, LowerEdge, UpperEdge, LeftEdge, RightEdge, Red, Green, Blue };

/// Whether a number stands for an exact one from which rounding may part it.
enum class Comparison { WithExact, None };

/// What one number of a method is called and where it comes from: tables, formulas, exports and the
/// command line show any method by this description without knowing it. How the number is read
/// stands in the same row of the method's table (NumberRow).
///
/// A formula assigns to the title ("y_B ← y_B′ + m₀₁") and names other numbers of the same sample,
/// span or set-up by their titles; a name with a prime is the number's value one step earlier.
/// Formula panels put the values in by these names. Where the formula is that of one edge or of
/// another, as the step has it, the description of all steps says "m" and NumberRow::specify the
/// edge's own name.
struct NumberDescription {
    QString id; ///< in CSV and JSON: "y_B"
    /// In a header and in formulas: "y_B". It depends on nothing but the run's settings, so that
    /// one header serves all rows of a table.
    QString title;
    QString unit; ///< "px", "levels", "levels/row", or empty
    QString toolTip; ///< one sentence, of no other number of its table
    QString formula; ///< "y_B ← y_B′ + m", or empty
    /// Where there is no earlier step: "y_B ← y₀"; empty where the formula always holds.
    QString startFormula = {};
    NumberGroup group = NumberGroup::Position;
    Comparison comparison = Comparison::None;
    NumberSubject subject = NumberSubject::General;
};

} // namespace pixelplumb
