// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/edgetesttraces.h"

namespace pixelplumb {

template TraceFunction traceWith<EdgeTestKernel<edgeEquationsForm>>;
template TraceFunction traceWith<EdgeTestKernel<incrementalEdgeEquationsForm>>;
template TraceFunction traceWith<EdgeTestKernel<solvedEdgeEquationsForm>>;
template TraceFunction traceWith<EdgeTestKernel<canonicalEdgeEquationsForm>>;
template TraceFunction traceWith<EdgeTestKernel<allSamplesBarycentricForm>>;
template TraceFunction traceWith<EdgeTestKernel<rectangleBarycentricForm>>;
template TraceFunction traceWith<EdgeTestKernel<incrementalBarycentricForm>>;
template TraceFunction traceWith<EdgeTestKernel<cramerBarycentricForm>>;
template TraceFunction traceWith<EdgeTestKernel<offScreenBarycentricForm>>;
template TraceFunction traceWith<EdgeTestKernel<relativeBarycentricForm>>;

template DrawFunction drawWith<MistakenEdgeTestKernel<edgeEquationsForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<edgeEquationsForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<incrementalEdgeEquationsForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<incrementalEdgeEquationsForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<canonicalEdgeEquationsForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<canonicalEdgeEquationsForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<allSamplesBarycentricForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<allSamplesBarycentricForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<rectangleBarycentricForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<rectangleBarycentricForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<incrementalBarycentricForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<incrementalBarycentricForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<cramerBarycentricForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<cramerBarycentricForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<offScreenBarycentricForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<offScreenBarycentricForm>>;
template DrawFunction drawWith<MistakenEdgeTestKernel<relativeBarycentricForm>>;
template TraceFunction traceMistaken<MistakenEdgeTestKernel<relativeBarycentricForm>>;

} // namespace pixelplumb
