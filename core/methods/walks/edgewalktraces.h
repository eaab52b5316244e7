// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/walks/edgewalkkernels.h"

/// Recording an edge walk is compiled in a source of its own, apart from drawing, and so is drawing
/// with mistakes: neither is timed, and the optimiser takes twice as long over timed code.
namespace pixelplumb {

extern template DrawFunction drawWith<VariedColumnScan>;
extern template DrawFunction drawWith<VariedRowWalk>;
extern template TraceFunction traceWith<ColumnScanKernel>;
extern template TraceFunction traceWith<VariedColumnScan>;
extern template TraceFunction traceMistaken<VariedColumnScan>;
extern template TraceFunction traceWith<RowWalk>;
extern template TraceFunction traceWith<VariedRowWalk>;
extern template TraceFunction traceMistaken<VariedRowWalk>;
extern template TraceFunction traceWith<ConstantRateWalk<SpanAxis::Column>>;
extern template TraceFunction traceWith<ConstantRateWalk<SpanAxis::Row>>;
extern template TraceFunction traceWith<BiasScan>;

} // namespace pixelplumb
