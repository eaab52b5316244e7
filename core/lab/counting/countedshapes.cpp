// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/countedkernel.h"
#include "core/methods/curves/curvekernels.h"
#include "core/methods/lines/linekernels.h"
#include "core/methods/polygons/polygonkernels.h"

namespace pixelplumb {

std::span<const CountedMethod> countedShapeMethods()
{
    static constexpr CountedMethod table[] = {
        {"line-dda", countWith<DdaKernel>},
        {"line-slope-intercept", countWith<SlopeInterceptKernel>},
        {"line-parametric", countWith<ParametricLineKernel>},
        {"line-bresenham", countWith<BresenhamKernel>},
        {"line-bresenham-symmetric", countWith<SymmetricKernel>},
        {"circle-midpoint", countWith<MidpointKernel>},
        {"circle-explicit", countWith<ExplicitKernel>},
        {"circle-parametric", countWith<ParametricKernel>},
        {"circle-fill", countWith<FillKernel>},
        {"bezier-fill", countWith<BezierFillKernel>},
        {"polygon-parity", countWith<ParityKernel>},
        {"polygon-fan", countWith<TriangulationKernel<fanOf>>},
        {"polygon-delaunay", countWith<TriangulationKernel<delaunayOf>>},
        {"polygon-tessellation", countWith<TessellationKernel>},
        {"polygon-outline", countWith<PolygonOutlineKernel>},
        {"point-address", countWith<PointKernel>},
        {"text-outlines", countWith<TextKernel>},
    };
    return table;
}

} // namespace pixelplumb
