// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/curves.h"
#include "core/methods/curves/strokes.h"
#include "core/methods/lines/lines.h"
#include "core/methods/polygons/bezierfill.h"
#include "core/methods/polygons/polygons.h"
#include "core/methods/polygons/text.h"
#include "core/methods/shading/interpolation.h"
#include "core/methods/tests/barycentric.h"
#include "core/methods/tests/edgeequations.h"
#include "core/methods/walks/columnscan.h"
#include "core/methods/walks/constantraterowwalk.h"
#include "core/methods/walks/edgewalks.h"
#include "core/methods/walks/outlinefill.h"

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
