// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/textwriter.h"
#include "core/number/jobprogress.h"
#include "core/runs/tracedscene.h"

#include <QStringList>

#include <optional>

namespace pixelplumb {

/// What a row of the table stands for.
enum class TraceLevel {
    SetUp, ///< a primitive
    Column, ///< a span: a column, a row or a step of the method
    Pixel, ///< a visited sample
    Stage, ///< a number of a stage between space and the frame, for a solid's triangle
};

/// Which rows of the run are written; an unset member does not restrict them.
struct RowChoice {
    std::optional<std::size_t> primitive;
    /// Of the pixel; in a table of spans, of the span's column or row. Set-ups and stages have
    /// neither.
    std::optional<std::int64_t> x, y;
    std::optional<std::size_t> position = {}; ///< in the run: only rows of steps done there
};

struct TraceExportOptions {
    TraceLevel level = TraceLevel::Column;
    TableFormat format = TableFormat::Csv;
    ProgressListener progress = {}; ///< called for each row of the run
    /// The columns to write, by name and in this order; empty: all of them, in a text table without
    /// the exact numbers and the errors.
    QStringList columns = {};
    TextNumbers textNumbers = TextNumbers::Mixed;
    RowChoice rows = {};
    /// The drawn frame of a scene that moves: written ahead of the rows, and in each row unless
    /// `columns` is set.
    std::optional<int> frame = {};
};

/// The names of all columns of a method's traces at a level.
QStringList traceColumnNames(const TraceNumbers &numbers, TraceLevel level);
/// The column name for a name or a title from a text table's header: delta_R for "ΔR". Empty where
/// there is none.
QString traceColumnNamed(const TraceNumbers &numbers, TraceLevel level, const QString &word);

/// Writes the numbers that the kernel used, with the exact numbers and the errors.
///
/// All levels begin with "step" (counted from 1, as in the window) and "primitive" (from 0),
/// preceded by "frame" where the scene moves. Set-up and column level: each of the method's numbers
/// under its id; where there is an exact value, "<id>_exact" and "<id>_error" (used − exact)
/// follow. Pixel level: "x", "y"; for R, G and B the used value, "_exact", "_error", "_level"
/// (rounded, before clamping) and "_byte"; "clamped", "before", "after" and "fate", then the
/// method's own numbers. Stage level: "stage", "point", what was "used", "used_exact" to 20 digits,
/// "used_error", the "formula" in symbols and with the "numbers" put in, and a "note" on the point.
/// JSON also gives the formulas by which the run computed each of the method's numbers, as in the
/// explanations of steps. False when the device refused to take it or options.progress ended it.
bool exportTrace(const TracedScene &traced, const TraceExportOptions &options, QIODevice &device);

} // namespace pixelplumb
