// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/oracle/oracle.h"
#include "core/trace/scantrace.h"

#include <QString>

namespace pixelplumb {

/// Columns of the table that are shown and hidden together.
enum class TraceColumnGroup { Position, Span, EdgeColours, ColourRates, FirstColour };

/// One column of a method's trace table: tables, exports and the command line show any method by
/// this description without knowing it.
struct TraceColumn {
    QString id; ///< in CSV and JSON: "y_B"
    QString title; ///< in a header: "y_B"
    QString unit; ///< "px", "levels", "levels/row", or empty
    QString toolTip; ///< one sentence
    QString formula; ///< "y_B ← y_B + m"
    TraceColumnGroup group = TraceColumnGroup::Position;
    /// The number that the kernel used.
    Quantity (*used)(const ColumnRecord &column) = nullptr;
    /// The exact number that it stands for; null where used is no approximation of anything (x,
    /// half).
    Quantity (*exact)(const oracle::ExactColumn &column) = nullptr;
};

} // namespace pixelplumb
