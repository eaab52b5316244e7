// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/tracetable.h"
#include "core/runs/explain/explanation.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The record of a primitive's set-up, with the exact numbers.
struct SetUpRow {
    std::size_t step = 0; ///< index
    PrimitiveKind kind = PrimitiveKind::Triangle;
    SetUpRecord record;
    std::optional<Rejection> rejection; ///< decided from the record's
    std::vector<Quantity> exact; ///< by TraceNumbers::setUp; may be shorter
};
TraceTable<SetUpRow> setUpTable(const std::vector<NumberDescription> &numbers);
SetUpRow setUpRow(const TracedScene &traced, std::size_t primitive);

/// The record of a span: a column, a row or a step of the method.
struct SpanRow {
    std::size_t step = 0; ///< index
    SpanRecord record;
    std::vector<Quantity> exact; ///< by TraceNumbers::span
};
/// By the method's descriptions, or by a run's headings.
TraceTable<SpanRow> spanTable(const std::vector<NumberDescription> &numbers);
SpanRow spanRow(const TracedScene &traced, std::size_t span);

/// A number of a stage between space and the frame, for a solid's triangle.
struct StageRow {
    std::size_t step = 0; ///< index
    std::size_t primitive = 0;
    QString stage, point, note;
    FormulaLine number;
};
TraceTable<StageRow> stageTable();
/// Empty for a triangle that the scene gives in the frame.
std::vector<StageRow> stageRows(const TracedScene &traced, std::size_t primitive);

/// The record of a sample, and what became of its pixel.
struct SampleRow {
    std::size_t step = 0; ///< index
    std::size_t primitive = 0;
    SampleRecord record;
    PixelChange change;
    ExactSample exact;
};
TraceTable<SampleRow> sampleTable(const std::vector<NumberDescription> &numbers);
/// A span's samples in order; fewer than it has where the trace was cut.
std::vector<SampleRow> sampleRows(const TracedScene &traced, std::size_t span);

} // namespace pixelplumb
