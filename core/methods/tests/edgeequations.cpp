// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/tests/edgetesttraces.h"

namespace pixelplumb {

Method edgeEquationsMethod()
{
    Method method = edgeTestMethod<edgeEquationsForm>();
    method.id = "edge-equations";
    method.title = QT_TRANSLATE_NOOP("core", "Edge equations");
    method.source
        = "Triangle Rasterization slides, “Edge equation” and “Edge sidedness”; Scan Conversion "
          "slides, “Implicit Equation for a 2D line” and “Edge Equations: Code”";
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Evaluates E = a·x + b·y + c of the three edges at every sample of the "
                            "clipped bounding box, with the sides flipped to be positive inside; "
                            "where the slide draws E > 0 alone, E = 0 is left to the fill rule.");
    return method;
}

Method incrementalEdgeEquationsMethod()
{
    Method method = edgeTestMethod<incrementalEdgeEquationsForm>();
    method.id = "edge-equations-incremental";
    method.title = QT_TRANSLATE_NOOP("core", "Edge equations, incremental");
    method.source
        = "Triangle Rasterization slides, “Triangle rasterization implementation guidelines”; Scan "
          "Conversion slides, “Edge Equations: Code”, the more efficient inner loop";
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Adds a to each edge function along a row and b from row to row, so "
                            "that a sample costs three additions and rounding errors add up.");
    return method;
}

Method solvedEdgeEquationsMethod()
{
    Method method = edgeTestMethod<solvedEdgeEquationsForm>();
    method.id = "edge-equations-solved";
    method.title = QT_TRANSLATE_NOOP("core", "Edge equations, solved system");
    method.source = "Rasterization slides, “Edge Equations”, “Given 2 points, compute A,B,C” and "
                    "“Testing Pixels”";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Solves A and B of each edge from its two points with C = −1 chosen; an edge whose line "
        "passes through (0, 0) has no such solution and gets C = 0.");
    return method;
}

Method canonicalEdgeEquationsMethod()
{
    Method method = edgeTestMethod<canonicalEdgeEquationsForm>();
    method.id = "edge-equations-canonical";
    method.title = QT_TRANSLATE_NOOP("core", "Edge equations, canonical end");
    method.family = MethodFamily::StableForms;
    method.source = "stable form of the Scan Conversion slides, “Triangle Rasterization Issues: "
                    "Shared Edge Ordering”";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Evaluates every edge from its end point that is smaller in (x, y) order and flips the "
        "sign, so that the two triangles of a shared edge see the same number in any arithmetic; "
        "in exact arithmetic all are integers.");
    return method;
}

} // namespace pixelplumb
