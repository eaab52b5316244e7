// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonkernels.h"
#include "core/methods/polygons/polygons.h"

namespace pixelplumb {

Method polygonOutlineMethod()
{
    Method method = polygonMethod(methodOf<PolygonOutlineKernel>());
    method.id = "polygon-outline";
    method.title = QT_TRANSLATE_NOOP("core", "Polygon outline");
    method.source = "Rasterization slides, “Output Primitives” and “Bresenham's Line Algorithm”; "
                    "Scan Conversion slides, “Polygons”";
    method.pseudocode
        = {{0, "given: the edges of each contour, from vertex to vertex, closed", {Moment::SetUp}},
           {0, "if no sample is to be drawn: done", {Moment::Rejected}},
           {0, "for each edge from (x₀, y₀) to (x₁, y₁):", {Moment::Begin}},
           {1,
            "if |y₁ − y₀| ≥ |x₁ − x₀|: exchange x and y, here and where a pixel is written",
            {Moment::Begin}},
           {1, "if x₁ < x₀: x₀, y₀, x₁, y₁ ← x₁, y₁, x₀, y₀", {Moment::Begin}},
           {1,
            "Δx, Δy ← x₁ − x₀, |y₁ − y₀|; s ← 1 if y₀ ≤ y₁, else −1; m ← s·Δy/Δx if Δx > 0, else 0",
            {Moment::Begin}},
           {1, "for each x from ⌈x₀⌉ to ⌊x₁⌋:", {Moment::Begin, Moment::Stay, Moment::Cross}},
           {2,
            "the first: y ← ⌊y₀ + (x − x₀)·m + ½⌋; p ← Δx·(2·s·(y₀ + (x + 1 − x₀)·m − y) − 1)",
            {Moment::Begin}},
           {2, "else if p < 0, or p = 0 and s < 0: p ← p + 2Δy", {Moment::Stay}},
           {2, "else: y ← y + s; p ← p + 2Δy − 2Δx", {Moment::Cross}},
           {2, "pixel (x, y) ← colour", {Moment::First}}};
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Draws each edge as a line by Bresenham's decisions between any two points of the lattice; "
        "a pixel in which two edges meet is written by both.");
    method.remarks = {"concave", "self-crossing", "holes"};
    method.fills = {ShapeFill::Outline};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = "an outline has no inside that an edge could bound";
    return method;
}

} // namespace pixelplumb
