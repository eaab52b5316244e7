// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/tests/edgetesttraces.h"

namespace pixelplumb {

Method allSamplesBarycentricMethod()
{
    Method method = edgeTestMethod<allSamplesBarycentricForm>();
    method.id = "barycentric-all";
    method.title = QT_TRANSLATE_NOOP("core", "Barycentric, all pixels");
    method.source = "Triangles slides, “for all x do for all y do”";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Computes α, β and γ for every pixel of the frame and draws it if all three lie within [0, "
        "1]; a sample on an edge is left to the fill rule.");
    return method;
}

Method rectangleBarycentricMethod()
{
    Method method = edgeTestMethod<rectangleBarycentricForm>();
    method.id = "barycentric-rectangle";
    method.title = QT_TRANSLATE_NOOP("core", "Barycentric, bounding rectangle");
    method.source = "Triangles slides, “use a bounding rectangle”: α = f_bc(x, y)/f_bc(x_a, y_a)";
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "The same for the samples between the smallest and the "
                                       "largest x and y of the vertices alone.");
    return method;
}

Method incrementalBarycentricMethod()
{
    Method method = edgeTestMethod<incrementalBarycentricForm>();
    method.id = "barycentric-incremental";
    method.title = QT_TRANSLATE_NOOP("core", "Barycentric, incremental");
    method.source = "Triangles slides, “make computation of bary. coords. incremental”";
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Adds to the weights and to the colour from sample to "
                                       "sample, and tests them against 0 alone.");
    return method;
}

Method cramerBarycentricMethod()
{
    Method method = edgeTestMethod<cramerBarycentricForm>();
    method.id = "barycentric-cramer";
    method.title = QT_TRANSLATE_NOOP("core", "Barycentric, Cramer's rule");
    method.source = "Rasterization slides, “Barycentric Coordinates of P (2D)” and “Cramer's Rule”";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Solves P = C + u·(A − C) + v·(B − C) by determinants and draws if u ≥ 0, v ≥ 0 and u + v "
        "≤ 1; a sample on an edge is left to the fill rule.");
    return method;
}

Method offScreenBarycentricMethod()
{
    Method method = edgeTestMethod<offScreenBarycentricForm>();
    method.id = "barycentric-off-screen";
    method.title = QT_TRANSLATE_NOOP("core", "Barycentric, off-screen point");
    method.source = "Triangles slides, “dealing with shared triangle edges”";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Gives a sample exactly on an edge to the triangle on the side of the off-screen point r: "
        "f_bc(a)·f_bc(r) > 0; an edge whose line passes through r is given to neither side.");
    method.fillRules = {FillRule::OffScreenPoint};
    method.pseudocode = underRule(method.pseudocode, FillRule::OffScreenPoint);
    method.fillRuleReason = "its test of the off-screen point is itself a fill rule";
    return method;
}

Method relativeBarycentricMethod()
{
    Method method = edgeTestMethod<relativeBarycentricForm>();
    method.id = "barycentric-relative";
    method.title = QT_TRANSLATE_NOOP("core", "Barycentric, relative");
    method.family = MethodFamily::StableForms;
    method.source = "stable form of the Triangles slides, α = f_bc(x, y)/f_bc(x_a, y_a)";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Evaluates each edge function from one of its vertices, so that the products stay small "
        "far from the origin; in float64 they are exact up to 2^15 px.");
    return method;
}

} // namespace pixelplumb
