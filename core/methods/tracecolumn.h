// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// Columns of the table that are shown and hidden together.
enum class TraceColumnGroup {
    Position, ///< which primitive, column, row or step
    Span, ///< bounds and covered samples
    Decision, ///< edge functions, weights, decision parameters
    EdgeColours,
    ColourRates,
    FirstColour,
};

/// Whether a number stands for an exact one from which rounding may part it.
enum class Comparison { WithExact, None };

/// One number of a method's records: tables, formulas, exports and the command line show any
/// method by this description without knowing it. The numbers themselves are the records' cells,
/// in the order of the descriptions.
///
/// A formula assigns to the title ("y_B ← y_B′ + m") and names other numbers of the same sample,
/// span or set-up by their titles; a name with a prime is the number's value one step earlier.
/// Formula panels put the values in by these names.
struct TraceColumn {
    QString id; ///< in CSV and JSON: "y_B"
    QString title; ///< in a header and in formulas: "y_B"
    QString unit; ///< "px", "levels", "levels/row", or empty
    QString toolTip; ///< one sentence
    QString formula; ///< "y_B ← y_B′ + m", or empty
    /// Where there is no earlier step: "y_B ← y₀"; empty where the formula always holds.
    QString startFormula = {};
    TraceColumnGroup group = TraceColumnGroup::Position;
    Comparison comparison = Comparison::None;
};

} // namespace pixelplumb
