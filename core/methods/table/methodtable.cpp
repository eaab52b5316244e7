// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"

namespace pixelplumb {

std::span<const Method> methods()
{
    static const std::vector<Method> table = {
        columnScanMethod(),
        rowWalkMethod(),
        edgeEquationsMethod(),
        incrementalEdgeEquationsMethod(),
        solvedEdgeEquationsMethod(),
        allSamplesBarycentricMethod(),
        rectangleBarycentricMethod(),
        incrementalBarycentricMethod(),
        cramerBarycentricMethod(),
        offScreenBarycentricMethod(),
        outlineFillMethod(),
        biasColumnScanMethod(),
        constantRateColumnScanMethod(),
        constantRateRowWalkMethod(),
        canonicalEdgeEquationsMethod(),
        relativeBarycentricMethod(),
        bilinearInterpolationMethod(),
        bilinearRowsInterpolationMethod(),
        planeInterpolationMethod(),
        barycentricInterpolationMethod(),
        lineDdaMethod(),
        lineSlopeInterceptMethod(),
        lineParametricMethod(),
        lineBresenhamMethod(),
        lineSymmetricMethod(),
        circleMidpointMethod(),
        circleExplicitMethod(),
        circleParametricMethod(),
        circleFillMethod(),
        bezierSubdivisionMethod(),
        bezierFillMethod(),
        strokeCoverageMethod(),
        polygonParityMethod(),
        polygonFanMethod(),
        polygonDelaunayMethod(),
        polygonTessellationMethod(),
        polygonOutlineMethod(),
        pointAddressMethod(),
        textOutlinesMethod(),
    };
    return table;
}

} // namespace pixelplumb
