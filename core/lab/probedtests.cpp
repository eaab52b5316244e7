// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/levelobserver.h"
#include "core/methods/edgetestmethod.h"

namespace pixelplumb {

std::span<const ProbedMethod> probedTests()
{
    static constexpr ProbedMethod table[] = {
        {"edge-equations", probeWith<EdgeTestKernel<edgeEquationsForm>>},
        {"edge-equations-incremental", probeWith<EdgeTestKernel<incrementalEdgeEquationsForm>>},
        {"edge-equations-solved", probeWith<EdgeTestKernel<solvedEdgeEquationsForm>>},
        {"edge-equations-canonical", probeWith<EdgeTestKernel<canonicalEdgeEquationsForm>>},
        {"barycentric-all", probeWith<EdgeTestKernel<allSamplesBarycentricForm>>},
        {"barycentric-rectangle", probeWith<EdgeTestKernel<rectangleBarycentricForm>>},
        {"barycentric-incremental", probeWith<EdgeTestKernel<incrementalBarycentricForm>>},
        {"barycentric-cramer", probeWith<EdgeTestKernel<cramerBarycentricForm>>},
        {"barycentric-off-screen", probeWith<EdgeTestKernel<offScreenBarycentricForm>>},
        {"barycentric-relative", probeWith<EdgeTestKernel<relativeBarycentricForm>>},
    };
    return table;
}

} // namespace pixelplumb
