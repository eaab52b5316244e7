// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/sceneprojection.h"
#include "tests/support/spacescenes.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>
#include <map>
#include <set>

using namespace pixelplumb;

namespace {

double valueOf(Attribute attribute) { return double(attribute) / double(attributeOne); }

Int128 doubledAreaOf(const std::vector<Triangle> &triangles)
{
    Int128 sum = 0;
    for (const Triangle &triangle : triangles)
        sum += doubledArea(triangle);
    return sum;
}

/// How often each directed edge is there, less how often its reverse is: nothing where every edge
/// has its partner.
std::map<std::pair<LatticePoint, LatticePoint>, int> openEdges(
    const std::vector<Triangle> &triangles)
{
    std::map<std::pair<LatticePoint, LatticePoint>, int> edges;
    for (const Triangle &triangle : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &from = triangle.vertices[i].position;
            const LatticePoint &to = triangle.vertices[(i + 1) % 3].position;
            if (from < to)
                ++edges[{from, to}];
            else if (to < from)
                --edges[{to, from}];
        }
    }
    std::erase_if(edges, [](const auto &edge) { return edge.second == 0; });
    return edges;
}

} // namespace

/// From three dimensions to triangles in the frame.
class TestSpace : public QObject {
    Q_OBJECT

private slots:
    void aPointIsWhereItsRayMeetsThePicturePlane()
    {
        // By similar triangles: the eye at (0, 0, 5) sees (1, 2, −3) at 8 in depth, and 90° show
        // as much above the axis as the depth.
        Scene scene = sceneOf({triangle3({1, 2, -3}, {-1, 0, 0}, {2, -1, 1})});
        scene.camera->fieldOfView = 90;

        const ProjectedSolids projected = projectedSolids(scene);

        QCOMPARE(projected.triangles.size(), 1U);
        const Vertex &vertex = projected.triangles[0].vertices[0];
        const double half = scene.frame.height / 2.0;
        QCOMPARE(vertex.position.x, Lattice((100 / 2.0 + 1.0 / 8 * half - 0.5) * 256));
        QCOMPARE(vertex.position.y, Lattice((half + 2.0 / 8 * half - 0.5) * 256));
        QCOMPARE(projected.attributes[0].vertices[0].w, 8 * attributeOne);
    }

    void theFramesCornersAreTheViewsCorners()
    {
        // At depth 5 and 60° the view is 2·5·tan 30° high and, in a frame of 100 × 80, 5/4 as wide.
        const double top = 5 * std::tan(std::acos(-1.0) / 6);
        const double right = top * 100 / 80;
        for (const auto origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft}) {
            Scene scene
                = sceneOf({triangle3({-right, -top, 0}, {right, -top, 0}, {right, top, 0})});
            scene.frame.origin = origin;
            scene.frame.firstColumn = -7;
            scene.frame.firstRow = 11;

            const auto triangle = projectedSolids(scene).triangles.at(0);

            const Lattice left = -7 * 256 - 128;
            const Lattice low = 11 * 256 - 128;
            const bool isUp = origin == FrameOrigin::BottomLeft;
            const Lattice bottom = isUp ? low : low + 80 * 256;
            const Lattice above = isUp ? low + 80 * 256 : low;
            QCOMPARE(triangle.vertices[0].position, (LatticePoint{left, bottom}));
            QCOMPARE(triangle.vertices[1].position, (LatticePoint{left + 100 * 256, bottom}));
            QCOMPARE(triangle.vertices[2].position, (LatticePoint{left + 100 * 256, above}));
        }
    }

    void depthRunsFromZeroAtTheNearPlaneToOneAtTheFarOne_data()
    {
        QTest::addColumn<Projection>("projection");
        QTest::newRow("perspective") << Projection::Perspective;
        QTest::newRow("orthographic") << Projection::Orthographic;
    }
    void depthRunsFromZeroAtTheNearPlaneToOneAtTheFarOne()
    {
        QFETCH(Projection, projection);
        Scene scene = sceneOf({triangle3({0, 0, 4}, {1, 0, -95}, {0, 1, 2})});
        scene.camera->projection = projection;

        const auto attributes = projectedSolids(scene).attributes.at(0);

        QCOMPARE(attributes.vertices[0].z, Attribute(0));
        QVERIFY(std::abs(attributes.vertices[1].z - attributeOne) <= 1);
        // At depth 3 of 1 … 100.
        const double middle
            = projection == Projection::Perspective ? (1 - 1 / 3.0) / (1 - 1 / 100.0) : 2 / 99.0;
        QVERIFY(std::abs(valueOf(attributes.vertices[2].z) - middle) <= std::ldexp(1, -24));
    }

    void clippingKeepsTheAreaBeyondTheNearPlane()
    {
        // Orthographic along a slanted triangle: what is cut off is known in the plane of x and z.
        Scene scene = sceneOf({triangle3({-2, -1, 10}, {2, -1, 10}, {0, 1, -10})});
        scene.camera->projection = Projection::Orthographic;
        scene.camera->height = 4;
        scene.camera->near = 5; // the plane z = 0, halfway between both ends

        const ProjectedSolids projected = projectedSolids(scene);

        // The upper half of the triangle in height has a quarter of its area: 4·2/2/4 = 1.
        const double unit = 80 / 4.0 * 256;
        const auto area = double(doubledAreaOf(projected.triangles)) / 2;
        QCOMPARE(projected.triangles.size(), 1U);
        QVERIFY(std::abs(area / (unit * unit) - 1) < 1e-3);
    }

    void clippedPolygonsHoldWhatLiesBeyondThePlaneAndNothingElse()
    {
        QRandomGenerator random(11);
        const auto number = [&random] { return random.generateDouble() * 8 - 4; };
        int clipped = 0;
        for (int round = 0; round < 200; ++round) {
            const Vector3 a = {number(), number(), number()};
            const Vector3 b = {number(), number(), number()};
            const Vector3 c = {number(), number(), number()};
            Scene scene = sceneOf({triangle3(a, b, c)});
            scene.camera->projection = Projection::Orthographic;
            scene.camera->near = 5;

            const ProjectedSolids projected = projectedSolids(scene);

            clipped += projected.triangles.size() != 1 ? 1 : 0;
            // Half-planes: points of the triangle, and whether a piece holds them.
            for (int i = 0; i < 100; ++i) {
                double s = random.generateDouble();
                double t = random.generateDouble();
                if (s + t > 1) {
                    s = 1 - s;
                    t = 1 - t;
                }
                const auto mixed = [&](std::size_t axis) {
                    return a[axis] + s * (b[axis] - a[axis]) + t * (c[axis] - a[axis]);
                };
                const double x = 100 / 2.0 + mixed(0) / 4 * 80 - 0.5;
                const double y = 80 / 2.0 + mixed(1) / 4 * 80 - 0.5;
                const auto distance = distanceFrom(projected.triangles, x, y);
                if (mixed(2) < 0)
                    QVERIFY2(distance <= 0.01, qPrintable(QString::number(distance)));
                else if (std::abs(doubledAreaInPixels(a, b, c)) > 100)
                    QVERIFY(distance > 0 || mixed(2) < 0.2);
            }
        }
        QVERIFY(clipped > 50);
    }

    void anEdgeIsCutAtTheSamePointFromBothOfItsFaces()
    {
        // Clipping a whole solid opens it along the near plane alone, and makes no T-junction.
        for (const SolidKind kind : {SolidKind::Sphere, SolidKind::Patch, SolidKind::Mesh}) {
            Scene scene = sceneOf({solidOf(kind)});
            scene.camera->eye = {0.3, 0.4, 1.9};
            scene.camera->near = 1.3;

            const ProjectedSolids projected = projectedSolids(scene);

            std::set<LatticePoint> onPlane;
            for (std::size_t i = 0; i < projected.triangles.size(); ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    if (projected.attributes[i].vertices[k].z == 0)
                        onPlane.insert(projected.triangles[i].vertices[k].position);
                }
            }
            const auto open = openEdges(projected.triangles);
            const std::set<LatticePoint> border = bordersOf(scene.solids[0], scene);
            int openOnPlane = 0;
            for (const auto &[edge, count] : open) {
                const bool isOnPlane
                    = onPlane.contains(edge.first) && onPlane.contains(edge.second);
                openOnPlane += isOnPlane ? 1 : 0;
                const bool isBorder = border.contains(edge.first) || border.contains(edge.second);
                QVERIFY(isOnPlane || isBorder);
            }
            QVERIFY(openOnPlane > 2);
        }
    }

    void verticesThatFacesShareAreOnePointAndOneDepth()
    {
        for (const SolidKind kind : {SolidKind::Sphere, SolidKind::Patch, SolidKind::Mesh}) {
            const Scene scene = sceneOf({solidOf(kind)});

            const ProjectedSolids projected = projectedSolids(scene);

            std::map<std::array<Attribute, 3>, std::tuple<LatticePoint, Attribute, Attribute>> seen;
            for (std::size_t i = 0; i < projected.triangles.size(); ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const VertexAttributes &vertex = projected.attributes[i].vertices[k];
                    const auto numbers = std::tuple(projected.triangles[i].vertices[k].position,
                                                    vertex.w, vertex.z);
                    const auto place = seen.emplace(vertex.place, numbers);
                    QCOMPARE(place.first->second, numbers);
                }
            }
            QVERIFY(seen.size() < 3 * projected.triangles.size() / 2);
            if (kind == SolidKind::Sphere)
                QVERIFY(openEdges(projected.triangles).empty());
        }
    }

    void whatLiesBeforeTheNearPlaneIsLostWithItsReason()
    {
        const Scene scene = sceneOf({triangle3({0, 0, 6}, {1, 0, 7}, {0, 1, 8}),
                                     triangle3({0, 0, 0}, {1, 0, 0}, {0, 1, 0})});

        const ProjectedSolids projected = projectedSolids(scene);

        QCOMPARE(projected.triangles.size(), 1U);
        QCOMPARE(projected.sources[0], (TriangleSource{1, 0, 0}));
        QCOMPARE(projected.lost.size(), 1U);
        QCOMPARE(projected.lost[0], (LostTriangle{{0, 0, 0}, ProjectionLoss::BehindNearPlane}));
    }

    void anEyeInsideATriangleSeesItEdgeOn()
    {
        // The eye lies in the triangle's own plane, y = 0.
        const Scene scene = sceneOf({triangle3({-3, 0, 9}, {3, 0, 9}, {0, 0, -9})});

        const ProjectedSolids projected = projectedSolids(scene);

        QVERIFY(!projected.triangles.empty());
        for (const Triangle &triangle : projected.triangles)
            QCOMPARE(doubledArea(triangle), Int128(0));
    }

    void placesBeyondTheCoordinatesAreLostWithTheirReason()
    {
        Scene scene = sceneOf({triangle3({1e9, 0, 3.9}, {1e9, 1, 3.9}, {1e9, 0, 3.8}),
                               triangle3({2e6, 0, -100}, {0, 0, -100}, {0, 1e3, -100})});

        const ProjectedSolids projected = projectedSolids(scene);

        QVERIFY(projected.triangles.empty());
        QCOMPARE(projected.lost.size(), 2U);
        QCOMPARE(projected.lost[0].loss, ProjectionLoss::OutsideCoordinates);
        QCOMPARE(projected.lost[1].loss, ProjectionLoss::OutsideAttributes);
    }

    void anEyeAtItsTargetSeesNothing()
    {
        Scene scene = sceneOf({solidOf(SolidKind::Sphere)});
        scene.camera->target = scene.camera->eye;

        const ProjectedSolids projected = projectedSolids(scene);

        QVERIFY(projected.triangles.empty());
        QCOMPARE(projected.lost.at(0).loss, ProjectionLoss::NoView);
    }

    void wIsTheViewDepthAndIsScaledOnlyWhereItMustBe()
    {
        Scene scene = sceneOf({triangle3({0, 0, 0}, {1, 0, -5}, {0, 1, 3})});
        QCOMPARE(projectedSolids(scene).wExponent, 0);
        QCOMPARE(projectedSolids(scene).attributes[0].vertices[1].w, 10 * attributeOne);

        scene.camera->near = 0.001;
        const ProjectedSolids close = projectedSolids(scene);
        QCOMPARE(close.wExponent, 10);
        QCOMPARE(close.attributes[0].vertices[1].w, 10240 * attributeOne);

        scene.solids[0].corners[1].position[2] = -1e6;
        scene.solids[0].corners[2].position[2] = 2 - 3e7;
        const ProjectedSolids far = projectedSolids(scene);
        QCOMPARE(far.wExponent, -5); // 3e7 < 2^25

        scene.camera->projection = Projection::Orthographic;
        QCOMPARE(projectedSolids(scene).wExponent, 0);
    }

    void aPlaneIsTwoTrianglesOfFourCorners()
    {
        Solid plane;
        plane.kind = SolidKind::Plane;
        plane.corners = {cornerAt({-1, -1, 0}), cornerAt({1, -1, 0}), cornerAt({-1, 1, 0})};

        const ProjectedSolids projected = projectedSolids(sceneOf({plane}));

        QCOMPARE(projected.triangles.size(), 2U);
        const auto &first = projected.attributes[0].vertices;
        const auto &second = projected.attributes[1].vertices;
        QCOMPARE(first[0].place, (std::array{-attributeOne, -attributeOne, Attribute(0)}));
        QCOMPARE(first[2].place, (std::array{attributeOne, attributeOne, Attribute(0)}));
        QCOMPARE(second[2].place, (std::array{-attributeOne, attributeOne, Attribute(0)}));
        QCOMPARE(first[2].texture, (std::array{attributeOne, attributeOne}));
        QCOMPARE(second[0].normal, (std::array{Attribute(0), Attribute(0), attributeOne}));
        QCOMPARE(projected.sources[1], (TriangleSource{0, 0, 1}));
    }

    void solidsAreDrawnBetweenTrianglesAndShapes()
    {
        Scene scene = sceneOf({solidOf(SolidKind::Sphere)});
        scene.triangles = {Triangle()};
        scene.attributes = {TriangleAttributes()};
        scene.shapes = {Shape()};
        scene.frame.pixelCentre = PixelCentre::Half;
        const ProjectedSolids projected = projectedSolids(scene);

        const Primitives primitives = primitivesOnSamples(scene);

        QCOMPARE(primitives.triangles.size(), 1 + projected.triangles.size());
        QCOMPARE(primitives.attributes.size(), 1 + projected.attributes.size());
        QCOMPARE(primitives.triangles[1], projected.triangles[0]); // on samples already
        QCOMPARE(primitives.attributes[1].triangle, 1U);
        QCOMPARE(primitives.kindOf(primitives.triangles.size()), PrimitiveKind::Line);
        QCOMPARE(primitives.appearance.viewerKind, Light::Kind::Positional);
        QCOMPARE(primitives.appearance.viewer[2], 5 * attributeOne);
    }
};

QTEST_GUILESS_MAIN(TestSpace)
#include "tst_space.moc"
