// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/kernelmethod.h"
#include "core/methods/polygonrecording.h"
#include "core/methods/polygons.h"
#include "core/scan/polygonpieces.h"

namespace pixelplumb {

namespace {

using Triangulate = Triangulation (*)(const Contours &);

/// The triangles of a triangulation are as many as the polygon's vertices; 128 bits for all of them
/// cost less than a second code path.
template <Triangulate triangulate>
struct TriangulationKernel : ShapeKernel<PrimitiveKind::Polygon>, InIntegers {
    template <class A>
    using Recording = PolygonRecording<A, PolygonForm::Triangles>;

    static Contours geometryOf(const Primitives &primitives, std::size_t index)
    {
        return contoursOf(primitives.shape(index));
    }
    template <class A, class Observer>
    static void scan(const Contours &contours, const ScanSettings &, FrameView frame,
                     Observer observer)
    {
        scanTriangles<A>(contours, triangulate(contours), frame, observer);
    }
};

template <Triangulate triangulate>
Method triangulatingMethod()
{
    Method method = polygonMethod();
    method.arithmetics = {Arithmetic::Exact};
    method.setUpColumns = polygonSetUpColumns(PolygonForm::Triangles);
    method.spanColumns = polygonRowColumns(PolygonForm::Triangles);
    method.sampleColumns = polygonSampleColumns(PolygonForm::Triangles);
    method.draw = drawWith<TriangulationKernel<triangulate>>;
    method.trace = traceWith<TriangulationKernel<triangulate>>;
    return method;
}

} // namespace

Method polygonFanMethod()
{
    Method method = triangulatingMethod<fanOf>();
    method.id = QStringLiteral("polygon-fan");
    method.title = QStringLiteral("Convex polygon as a fan");
    method.source = QStringLiteral("seed 003, slide “From Polygons to Triangles”");
    method.summary = QStringLiteral("Breaks a convex polygon into the triangles that its first "
                                    "vertex makes with its edges, and fills each row by row.");
    method.effects += {QStringLiteral("convex"), QStringLiteral("shared edges")};
    return method;
}

Method polygonDelaunayMethod()
{
    Method method = triangulatingMethod<delaunayOf>();
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
    return method;
}

} // namespace pixelplumb
