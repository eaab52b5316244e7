// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/countedkernel.h"
#include "core/methods/shading/interpolationkernel.h"
#include "core/methods/tests/edgetestmethod.h"
#include "core/methods/walks/edgewalkkernels.h"
#include "core/methods/walks/outlinefill.h"

namespace pixelplumb {

std::span<const CountedMethod> countedTriangleMethods()
{
    using enum InterpolationForm;
    static constexpr CountedMethod table[] = {
        {"column-scan", countWith<ColumnScanKernel>},
        {"row-walk", countWith<RowWalk>},
        {"column-scan-bias", countWith<BiasScan>},
        {"column-scan-constant-rate", countWith<ConstantRateWalk<SpanAxis::Column>>},
        {"row-walk-constant-rate", countWith<ConstantRateWalk<SpanAxis::Row>>},
        {"edge-equations", countWith<EdgeTestKernel<edgeEquationsForm>>},
        {"edge-equations-incremental", countWith<EdgeTestKernel<incrementalEdgeEquationsForm>>},
        {"edge-equations-solved", countWith<EdgeTestKernel<solvedEdgeEquationsForm>>},
        {"edge-equations-canonical", countWith<EdgeTestKernel<canonicalEdgeEquationsForm>>},
        {"barycentric-all", countWith<EdgeTestKernel<allSamplesBarycentricForm>>},
        {"barycentric-rectangle", countWith<EdgeTestKernel<rectangleBarycentricForm>>},
        {"barycentric-incremental", countWith<EdgeTestKernel<incrementalBarycentricForm>>},
        {"barycentric-cramer", countWith<EdgeTestKernel<cramerBarycentricForm>>},
        {"barycentric-off-screen", countWith<EdgeTestKernel<offScreenBarycentricForm>>},
        {"barycentric-relative", countWith<EdgeTestKernel<relativeBarycentricForm>>},
        {"midpoint-outline-fill", countWith<OutlineFillKernel>},
        {"interpolate-bilinear", countWith<InterpolationKernel<Bilinear>>},
        {"interpolate-bilinear-rows", countWith<InterpolationKernel<BilinearRows>>},
        {"interpolate-plane", countWith<InterpolationKernel<Plane>>},
        {"interpolate-barycentric", countWith<InterpolationKernel<Barycentric>>},
    };
    return table;
}

} // namespace pixelplumb
