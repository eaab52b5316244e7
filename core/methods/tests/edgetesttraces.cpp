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

} // namespace pixelplumb
