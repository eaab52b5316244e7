// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/outlinefill.h"

namespace pixelplumb {

Method outlineFillMethod()
{
    Method method = methodOf<OutlineFillKernel>();
    method.id = QStringLiteral("midpoint-outline-fill");
    method.title = QStringLiteral("Midpoint outline, filled");
    method.source = QStringLiteral("Triangles slides, “Use Midpoint Algorithm for edges and fill "
                                   "in?”; Rasterization slides, “Bresenham's Line Algorithm”");
    method.summary = QStringLiteral("Draws the three edges as lines of whole pixels and fills each "
                                    "column between the lowest and the highest of them: pixels "
                                    "nearest to an edge are painted on whichever side of it they "
                                    "lie, those of a shared edge twice.");
    method.remarks += QStringLiteral("whole-pixel vertices");
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("the pixels of the outline are painted whatever side of "
                                           "the edge they lie on");
    return method;
}

} // namespace pixelplumb
