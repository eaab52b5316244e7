// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygonkernels.h"
#include "core/methods/polygons.h"

namespace pixelplumb {

Method polygonOutlineMethod()
{
    Method method = polygonMethod(methodOf<PolygonOutlineKernel>());
    method.id = QStringLiteral("polygon-outline");
    method.title = QStringLiteral("Polygon outline");
    method.source = QStringLiteral("Rasterization slides, “Output Primitives” and “Bresenham's "
                                   "Line Algorithm”; Scan Conversion slides, “Polygons”");
    method.pseudocode = {
        {0,
         QStringLiteral("edges ← of each contour, from vertex to vertex, closed"),
         {Moment::SetUp}},
        {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
        {0, QStringLiteral("for each edge:"), {Moment::Begin}},
        {1,
         QStringLiteral("if |Δy| ≥ |Δx|: exchange x and y, here and where a pixel is written"),
         {Moment::Begin}},
        {1, QStringLiteral("(x₀, y₀) ← its end with the smaller x"), {Moment::Begin}},
        {1,
         QStringLiteral("(x, y) ← the pixel of the first column, by a division; p ← the decision "
                        "about the next"),
         {Moment::Begin}},
        {1,
         QStringLiteral("for each column, with a step before each but the first:"),
         {Moment::Begin, Moment::Stay, Moment::Cross}},
        {2,
         QStringLiteral("if p < 0, or p = 0 on a falling edge: x ← x + 1, p ← p + 2Δy"),
         {Moment::Stay}},
        {2, QStringLiteral("else: x ← x + 1, y a step across, p ← p + 2Δy − 2Δx"), {Moment::Cross}},
        {2, QStringLiteral("pixel (x, y) ← colour"), {Moment::First}}};
    method.summary = QStringLiteral("Draws each edge as a line by Bresenham's decisions between "
                                    "any two points of the lattice; a pixel in which two edges "
                                    "meet is written by both.");
    method.remarks
        = {QStringLiteral("concave"), QStringLiteral("self-crossing"), QStringLiteral("holes")};
    method.fills = {ShapeFill::Outline};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("an outline has no inside that an edge could bound");
    return method;
}

} // namespace pixelplumb
