// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/sceneprojection.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>
#include <map>

namespace tst_space {

using namespace pixelplumb;

namespace {

double valueOf(Attribute attribute) { return double(attribute) / double(attributeOne); }

} // namespace

/// From three dimensions to triangles in the frame.
class TestSpace : public QObject {
    Q_OBJECT

private slots:
    void aPointIsWhereItsRayMeetsThePicturePlane()
    {
        // By similar triangles: the eye at (0, 0, 5) sees (1, 2, −3) at depth 8, and 90° show as
        // much above the axis as the depth.
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

PIXELPLUMB_TEST(TestSpace)

} // namespace tst_space

#include "tst_space.moc"
