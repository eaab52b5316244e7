// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// Groups of numbers that tables show and hide together.
enum class NumberGroup {
    Position, ///< which primitive, column, row or step: only what identifies rows
    Span, ///< bounds and covered samples
    Decision, ///< edge functions, weights, decision parameters
    EdgeColours,
    ColourRates,
    FirstColour,
};

/// What a number belongs to, where the window marks that with a sign or a heading.
enum class NumberSubject { General, LowerEdge, UpperEdge, LeftEdge, RightEdge, Red, Green, Blue };

/// Whether a number has an exact counterpart from which rounding may separate it.
enum class Comparison { WithExact, None };

/// The name and origin of one number of a method. With this description, tables, formulas, exports
/// and the command line show any method without knowing it. How the number is read is in the same
/// row of the method's table (NumberRow).
///
/// A formula assigns to the title ("y_B ← y_B′ + m₀₁") and names other numbers of the same sample,
/// span or set-up by their titles; a name with a prime is the number's value one step earlier.
/// Formula panels substitute values by these names. Where the formula uses one edge or another,
/// depending on the step, the description for all steps says "m" and NumberRow::specify puts in the
/// edge's own name.
struct NumberDescription {
    QString id; ///< in CSV and JSON: "y_B"
    /// In a header and in formulas: "y_B". It depends only on the run's settings, so that one
    /// header serves all rows of a table.
    QString title;
    QString unit = {}; ///< "px", "levels", "levels/row", or empty
    QString toolTip; ///< one sentence, unique within its table
    QString formula = {}; ///< "y_B ← y_B′ + m", or empty
    /// For the first step: "y_B ← y₀"; empty where the formula always holds.
    QString startFormula = {};
    NumberGroup group = NumberGroup::Position;
    Comparison comparison = Comparison::None;
    NumberSubject subject = NumberSubject::General;
};

} // namespace pixelplumb
