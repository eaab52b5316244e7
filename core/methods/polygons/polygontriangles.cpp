// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonkernels.h"
#include "core/methods/polygons/polygons.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

/// A method that triangulates; `triangles` is its first line, which says which triangles it makes.
template <class Kernel>
Method triangulatingMethod(const QString &triangles)
{
    Method method = polygonMethod(methodOf<Kernel>());
    method.arithmetics = {Arithmetic::Exact};
    method.pseudocode = {{0, triangles, {Moment::SetUp}},
                         {0, "if no sample is to be drawn: done", {Moment::Rejected}},
                         {0, "for each triangle, with its three edges:", {Moment::Begin}}};
    std::ranges::move(crossingLines(1), std::back_inserter(method.pseudocode));
    method.pseudocode.push_back(
        {2, "for each x from ⌈min x_k⌉ to ⌈max x_k⌉ − 1:", {Moment::First, Moment::Next}});
    method.pseudocode.push_back({3, "pixel (x, y) ← colour", {Moment::First, Moment::Next}});
    return method;
}

} // namespace

Method polygonFanMethod()
{
    Method method = triangulatingMethod<TriangulationKernel<fanOf>>(
        "given: the triangles of the first vertex with each edge that it is not on");
    method.id = "polygon-fan";
    method.title = QT_TRANSLATE_NOOP("core", "Convex polygon as a fan");
    method.source = "Scan Conversion slides, “From Polygons to Triangles”";
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Breaks a convex polygon into the triangles that its first "
                                       "vertex makes with its edges, and fills each row by row.");
    method.remarks = {"convex", "shared edges"};
    return method;
}

Method polygonDelaunayMethod()
{
    Method method = triangulatingMethod<TriangulationKernel<delaunayOf>>(
        "given: the triangles of the constrained Delaunay triangulation that are inside");
    method.id = "polygon-delaunay";
    method.title = QT_TRANSLATE_NOOP("core", "Polygon by Delaunay triangulation");
    method.source = "Rasterization slides, “Triangulation”; Scan Conversion slides, “From Polygons "
                    "to Triangles”";
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Breaks a polygon that does not cross itself into the triangles of its "
                            "constrained Delaunay triangulation, and fills each row by row.");
    method.remarks = {"concave", "holes", "even-odd", "non-zero", "shared edges"};
    return method;
}

Method polygonTessellationMethod()
{
    Method method = triangulatingMethod<TessellationKernel>(
        "given: the triangles of the constrained Delaunay triangulation that are inside, with a "
        "vertex, to "
        "1/256 px, where edges cross");
    method.id = "polygon-tessellation";
    method.title = QT_TRANSLATE_NOOP("core", "Polygon by tessellation");
    method.source = "Scan Conversion slides, “From Polygons to Triangles”";
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Breaks any polygon into triangles, also one that crosses itself: "
                            "crossings become vertices, moved to the nearest multiple of 1/256 px, "
                            "by which a sample beside an edge may change its side.");
    method.remarks = {"concave", "self-crossing", "holes", "even-odd", "non-zero", "shared edges"};
    method.stableArithmetics = {};
    return method;
}

} // namespace pixelplumb
