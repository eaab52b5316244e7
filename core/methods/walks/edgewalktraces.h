// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/walks/edgewalkkernels.h"

/// Recording an edge walk is compiled in a source of its own, apart from drawing: it is not timed,
/// and the optimiser takes twice as long over timed code.
namespace pixelplumb {

extern template TraceFunction traceWith<ColumnScanKernel>;
extern template TraceFunction traceWith<VariedColumnScan>;
extern template TraceFunction traceWith<RowWalk>;
extern template TraceFunction traceWith<VariedRowWalk>;
extern template TraceFunction traceWith<ConstantRateWalk<SpanAxis::Column>>;
extern template TraceFunction traceWith<ConstantRateWalk<SpanAxis::Row>>;
extern template TraceFunction traceWith<BiasScan>;

} // namespace pixelplumb
