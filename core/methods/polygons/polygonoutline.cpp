// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonkernels.h"
#include "core/methods/polygons/polygons.h"

namespace pixelplumb {

Method polygonOutlineMethod()
{
    Method method = polygonMethod(methodOf<PolygonOutlineKernel>());
    method.id = QStringLiteral("polygon-outline");
    method.title = QStringLiteral(QT_TRANSLATE_NOOP("core", "Polygon outline"));
    method.source = QStringLiteral("Rasterization slides, “Output Primitives” and “Bresenham's "
                                   "Line Algorithm”; Scan Conversion slides, “Polygons”");
    method.pseudocode = {
        {0,
         QStringLiteral("edges ← of each contour, from vertex to vertex, closed"),
         {Moment::SetUp}},
        {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
        {0, QStringLiteral("for each edge from (x₀, y₀) to (x₁, y₁):"), {Moment::Begin}},
        {1,
         QStringLiteral("if |y₁ − y₀| ≥ |x₁ − x₀|: exchange x and y, here and where a pixel is "
                        "written"),
         {Moment::Begin}},
        {1, QStringLiteral("if x₁ < x₀: x₀, y₀, x₁, y₁ ← x₁, y₁, x₀, y₀"), {Moment::Begin}},
        {1,
         QStringLiteral("Δx, Δy ← x₁ − x₀, |y₁ − y₀|; s ← 1 if y₀ ≤ y₁, else −1; m ← s·Δy/Δx if "
                        "Δx > 0, else 0"),
         {Moment::Begin}},
        {1,
         QStringLiteral("for each x from ⌈x₀⌉ to ⌊x₁⌋:"),
         {Moment::Begin, Moment::Stay, Moment::Cross}},
        {2,
         QStringLiteral("the first: y ← ⌊y₀ + (x − x₀)·m + ½⌋; p ← Δx·(2·s·(y₀ + (x + 1 − x₀)·m − "
                        "y) − 1)"),
         {Moment::Begin}},
        {2, QStringLiteral("else if p < 0, or p = 0 and s < 0: p ← p + 2Δy"), {Moment::Stay}},
        {2, QStringLiteral("else: y ← y + s; p ← p + 2Δy − 2Δx"), {Moment::Cross}},
        {2, QStringLiteral("pixel (x, y) ← colour"), {Moment::First}}};
    method.summary = QStringLiteral(
        QT_TRANSLATE_NOOP("core",
                          "Draws each edge as a line by Bresenham's decisions between "
                          "any two points of the lattice; a pixel in which two edges "
                          "meet is written by both."));
    method.remarks
        = {QStringLiteral("concave"), QStringLiteral("self-crossing"), QStringLiteral("holes")};
    method.fills = {ShapeFill::Outline};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("an outline has no inside that an edge could bound");
    return method;
}

} // namespace pixelplumb
