// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/sceneprojection.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>
#include <set>

namespace tst_nearclip {

using namespace pixelplumb;

namespace {

Int128 doubledAreaOf(const std::vector<Triangle> &triangles)
{
    Int128 sum = 0;
    for (const Triangle &triangle : triangles)
        sum += doubledArea(triangle);
    return sum;
}

} // namespace

/// What the near plane leaves of faces.
class TestNearClip : public QObject {
    Q_OBJECT

private slots:
    void clippingKeepsTheAreaBeyondTheNearPlane()
    {
        // Orthographic view along a slanted triangle: the clipped part is known in the xz plane.
        Scene scene = sceneOf({triangle3({-2, -1, 10}, {2, -1, 10}, {0, 1, -10})});
        scene.camera->projection = Projection::Orthographic;
        scene.camera->height = 4;
        scene.camera->near = 5; // the plane z = 0, halfway between both ends

        const ProjectedSolids projected = projectedSolids(scene);

        // The upper half of the triangle's height has a quarter of its area: 4·2/2/4 = 1.
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
            // Half-planes: points of the triangle, and whether a piece contains them.
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
        // Clipping a whole solid opens it only along the near plane and makes no T-junction.
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

    void aCornerOnTheNearPlaneIsCutOnce_data()
    {
        QTest::addColumn<Solid>("face");
        QTest::addColumn<int>("triangles");
        // The plane is z = 2.
        QTest::newRow("a corner on it, one beyond it, one before it")
            << triangle3({-2, -2, 2}, {2, -2, 0}, {2, 7, 4}) << 1;
        QTest::newRow("the same the other way round")
            << triangle3({-2, -2, 2}, {2, 7, 4}, {2, -2, 0}) << 1;
        QTest::newRow("a corner on it, the others before it")
            << triangle3({-2, -2, 2}, {2, -2, 3}, {2, 7, 4}) << 0;
        QTest::newRow("an edge on it, the rest before it")
            << triangle3({-2, -2, 2}, {2, -2, 2}, {2, 7, 4}) << 0;
        QTest::newRow("an edge on it, the rest beyond it")
            << triangle3({-2, -2, 2}, {2, -2, 2}, {2, 7, 0}) << 1;
        QTest::newRow("all on it") << triangle3({-2, -2, 2}, {2, -2, 2}, {2, 7, 2}) << 1;
        QTest::newRow("none on it, one before it")
            << triangle3({-2, -2, 1}, {2, -2, 1}, {2, 7, 3}) << 2;
    }
    void aCornerOnTheNearPlaneIsCutOnce()
    {
        QFETCH(Solid, face);
        QFETCH(int, triangles);
        Scene scene = sceneOf({face});
        scene.camera->projection = Projection::Orthographic;
        scene.camera->height = 8;
        scene.camera->eye = {0, 0, 4};
        scene.camera->near = 2;

        const ProjectedSolids projected = projectedSolids(scene);

        QCOMPARE(int(projected.triangles.size()), triangles);
        QCOMPARE(projected.lost.size(), triangles == 0 ? 1U : 0U);
        for (const Triangle &triangle : projected.triangles)
            QVERIFY(doubledArea(triangle) != 0);
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
};

PIXELPLUMB_TEST(TestNearClip)

} // namespace tst_nearclip

#include "tst_nearclip.moc"
