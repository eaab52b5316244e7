// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tests/edgetestmethod.h"

/// Recording an edge test is compiled in a source of its own, apart from drawing: it is not timed,
/// and the optimiser takes twice as long over timed code.
namespace pixelplumb {

extern template TraceFunction traceWith<EdgeTestKernel<edgeEquationsForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<incrementalEdgeEquationsForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<solvedEdgeEquationsForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<canonicalEdgeEquationsForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<allSamplesBarycentricForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<rectangleBarycentricForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<incrementalBarycentricForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<cramerBarycentricForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<offScreenBarycentricForm>>;
extern template TraceFunction traceWith<EdgeTestKernel<relativeBarycentricForm>>;

} // namespace pixelplumb
