// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/barycentric.h"
#include "core/methods/bezierfill.h"
#include "core/methods/columnscan.h"
#include "core/methods/constantraterowwalk.h"
#include "core/methods/curves.h"
#include "core/methods/edgeequations.h"
#include "core/methods/edgewalks.h"
#include "core/methods/interpolation.h"
#include "core/methods/lines.h"
#include "core/methods/outlinefill.h"
#include "core/methods/polygons.h"
#include "core/methods/strokes.h"
#include "core/methods/text.h"

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
