// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/edgewalktraces.h"

namespace pixelplumb {

template TraceFunction traceWith<ColumnScanKernel>;
template TraceFunction traceWith<VariedColumnScan>;
template TraceFunction traceMistaken<VariedColumnScan>;
template TraceFunction traceWith<RowWalk>;
template TraceFunction traceWith<VariedRowWalk>;
template TraceFunction traceMistaken<VariedRowWalk>;
template TraceFunction traceWith<ConstantRateWalk<SpanAxis::Column>>;
template TraceFunction traceWith<ConstantRateWalk<SpanAxis::Row>>;
template TraceFunction traceWith<BiasScan>;

} // namespace pixelplumb
