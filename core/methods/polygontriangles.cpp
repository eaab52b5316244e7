// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygonrecording.h"
#include "core/methods/polygons.h"
#include "core/scan/polygonpieces.h"

namespace pixelplumb {

namespace {

// The triangles of a triangulation are as many as the polygon's vertices; 128 bits for all of them
// cost less than a second code path.
using Exact = ExactArithmetic<Int128>;

using Triangulate = Triangulation (*)(const Contours &);

template <Triangulate triangulate>
void draw(const Primitives &primitives, const ScanSettings &, FrameView frame)
{
    for (const Shape &shape : primitives.shapes) {
        if (shape.kind != PrimitiveKind::Polygon)
            continue;
        const Contours contours = contoursOf(shape);
        scanTriangles<Exact>(contours, triangulate(contours), frame, NullObserver{});
    }
}

template <Triangulate triangulate>
std::unique_ptr<ScanTrace> trace(const Primitives &primitives, const ScanSettings &settings,
                                 FrameView frame, const TraceOptions &options)
{
    return recordTrace<PolygonRecording<Exact, PolygonForm::Triangles>>(
        primitives.size(), settings, options,
        [&](std::size_t primitive) {
            return primitives.kindOf(primitive) == PrimitiveKind::Polygon;
        },
        [&](std::size_t primitive, const auto &recorder) {
            const Contours contours = contoursOf(primitives.shape(primitive));
            scanTriangles<Exact>(contours, triangulate(contours), frame, recorder);
        });
}

Method triangulatingMethod()
{
    Method method = polygonMethod();
    method.arithmetics = {Arithmetic::Exact};
    method.setUpColumns = polygonSetUpColumns(PolygonForm::Triangles);
    method.spanColumns = polygonRowColumns(PolygonForm::Triangles);
    method.sampleColumns = polygonSampleColumns(PolygonForm::Triangles);
    return method;
}

} // namespace

Method polygonFanMethod()
{
    Method method = triangulatingMethod();
    method.id = QStringLiteral("polygon-fan");
    method.title = QStringLiteral("Convex polygon as a fan");
    method.source = QStringLiteral("seed 003, slide “From Polygons to Triangles”");
    method.summary = QStringLiteral("Breaks a convex polygon into the triangles that its first "
                                    "vertex makes with its edges, and fills each row by row.");
    method.effects += {QStringLiteral("convex"), QStringLiteral("shared edges")};
    method.draw = draw<fanOf>;
    method.trace = trace<fanOf>;
    return method;
}

Method polygonDelaunayMethod()
{
    Method method = triangulatingMethod();
    method.id = QStringLiteral("polygon-delaunay");
    method.title = QStringLiteral("Polygon by Delaunay triangulation");
    method.source = QStringLiteral("seed 002, slide “Triangulation”; seed 003, slide “From "
                                   "Polygons to Triangles”");
    method.summary = QStringLiteral("Breaks a polygon that does not cross itself into the "
                                    "triangles of its constrained Delaunay triangulation, and "
                                    "fills each row by row.");
    method.effects
        += {QStringLiteral("concave"), QStringLiteral("holes"), QStringLiteral("even-odd"),
            QStringLiteral("non-zero"), QStringLiteral("shared edges")};
    method.draw = draw<delaunayOf>;
    method.trace = trace<delaunayOf>;
    return method;
}

} // namespace pixelplumb
