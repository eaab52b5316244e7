// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tests/edgetestmethod.h"

/// Recording an edge test is compiled in a source of its own, apart from drawing, and so is what
/// makes mistakes: neither is timed, and the optimiser takes twice as long over timed code.
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

extern template DrawFunction drawWith<MistakenEdgeTestKernel<edgeEquationsForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<edgeEquationsForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<incrementalEdgeEquationsForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<incrementalEdgeEquationsForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<canonicalEdgeEquationsForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<canonicalEdgeEquationsForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<allSamplesBarycentricForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<allSamplesBarycentricForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<rectangleBarycentricForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<rectangleBarycentricForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<incrementalBarycentricForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<incrementalBarycentricForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<cramerBarycentricForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<cramerBarycentricForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<offScreenBarycentricForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<offScreenBarycentricForm>>;
extern template DrawFunction drawWith<MistakenEdgeTestKernel<relativeBarycentricForm>>;
extern template TraceFunction traceMistaken<MistakenEdgeTestKernel<relativeBarycentricForm>>;

} // namespace pixelplumb
