// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/textwriter.h"
#include "core/number/jobprogress.h"
#include "core/runs/tracedscene.h"

#include <QStringList>

#include <optional>

namespace pixelplumb {

/// What a row of the table is.
enum class TraceLevel {
    SetUp, ///< a primitive
    Column, ///< a span: a column, a row or a step of the method
    Pixel, ///< a visited sample
    Stage, ///< a number of a stage on the way of a solid's triangle from space to the frame
};

/// Which rows of the run are written; what is not set leaves all.
struct RowChoice {
    std::optional<std::size_t> primitive;
    /// Of the pixel; in a table of spans, of the column or the row that the span is. Set-ups and
    /// stages have neither.
    std::optional<std::int64_t> x, y;
    std::optional<std::size_t> position = {}; ///< of the run: the rows of the steps done there
};

struct TraceExportOptions {
    TraceLevel level = TraceLevel::Column;
    TableFormat format = TableFormat::Csv;
    ProgressListener progress = {}; ///< hears of each row of the run
    /// The columns that are written, by name and in this order; empty: all of them, in a text table
    /// without the exact numbers and the errors.
    QStringList columns = {};
    TextNumbers textNumbers = TextNumbers::Mixed;
    RowChoice rows = {};
    /// Of a scene that moves, the one that was drawn: told ahead of the rows, and in each unless
    /// `columns` chooses.
    std::optional<int> frame = {};
};

/// The names of all columns that a method's traces have at a level.
QStringList traceColumnNames(const TraceNumbers &numbers, TraceLevel level);
/// The name of the column that a name or the title in a text table's header means: delta_R of
/// "ΔR". Empty where there is none.
QString traceColumnNamed(const TraceNumbers &numbers, TraceLevel level, const QString &word);

/// Writes the numbers that the kernel used, with the exact ones and the errors beside them.
///
/// All levels begin with "step" (counted from 1, as in the window) and "primitive" (from 0), behind
/// "frame" where the scene moves. Set-up
/// and column level: each of the method's numbers under its id; where there is an exact value,
/// "<id>_exact" and "<id>_error" (used − exact) follow. Pixel level: "x", "y"; for R, G and B the
/// used value, "_exact", "_error", "_level" (rounded, before clamping) and "_byte"; "clamped",
/// "before", "after" and "fate", then the method's own numbers. Stage level: "stage", "point",
/// what was "used", "used_exact", to 20 digits, "used_error", the "formula" of the number in
/// symbols and with the "numbers" put in, and a "note" on the point. JSON
/// tells of each of the method's numbers by which formulas the run computed it, as the steps are
/// explained. False when the device refused
/// to take it or options.progress ended it.
bool exportTrace(const TracedScene &traced, const TraceExportOptions &options, QIODevice &device);

} // namespace pixelplumb
