// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/overdraw.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_overdraw {

using namespace pixelplumb;

namespace {

Triangle triangle(const LatticePoint &a, const LatticePoint &b, const LatticePoint &c)
{
    Triangle result;
    result.vertices[0].position = a;
    result.vertices[1].position = b;
    result.vertices[2].position = c;
    return result;
}

/// A square of two triangles that share the diagonal.
Scene square(FillRule rule)
{
    Scene scene;
    scene.frame.width = 24;
    scene.frame.height = 24;
    scene.settings.fillRule = rule;
    scene.triangles = {triangle(latticePixel(4, 4), latticePixel(16, 4), latticePixel(16, 16)),
                       triangle(latticePixel(4, 4), latticePixel(16, 16), latticePixel(4, 16))};
    return scene;
}

} // namespace

class TestOverdraw : public QObject {
    Q_OBJECT

private slots:
    void findsNeitherGapNorOverdrawInAWatertightMesh()
    {
        const OverdrawMap map = overdrawOf(*traceScene(square(FillRule::HalfOpenColumn)));

        QCOMPARE(map.writtenPixels(), 12 * 12);
        QCOMPARE(map.overdrawnPixels(), 0);
        QCOMPARE(map.gaps(), 0);
        QCOMPARE(map.mostWrites(), 1);
    }

    void countsTheSharedEdgeTwiceUnderTheClosedRule()
    {
        const OverdrawMap map = overdrawOf(*traceScene(square(FillRule::Closed)));

        QCOMPARE(map.writtenPixels(), 13 * 13);
        QCOMPARE(map.overdrawnPixels(), 13); // the diagonal with both ends
        QCOMPARE(map.writesAt(10, 10), 2);
        QCOMPARE(map.writesAt(10, 9), 1);
        QCOMPARE(map.writesAt(2, 2), 0);
        QCOMPARE(map.gaps(), 0);
    }

    void countsEachPrimitiveOnce()
    {
        Scene scene = square(FillRule::Closed);
        scene.triangles = {scene.triangles[0], scene.triangles[0], scene.triangles[0]};

        const OverdrawMap map = overdrawOf(*traceScene(scene));

        QCOMPARE(map.mostWrites(), 3);
        QCOMPARE(map.overdrawnPixels(), map.writtenPixels());
    }

    void findsTheSamplesThatARoundingRunMisses()
    {
        Scene scene = square(FillRule::Closed);
        scene.frame.width = 1001;
        scene.frame.height = 701;
        scene.settings.arithmetic = Arithmetic::Float32;
        scene.triangles
            = {triangle(latticePixel(0, 0), latticePixel(1000, 100), latticePixel(1000, 700))};
        const auto traced = traceScene(scene);

        const OverdrawMap map = overdrawOf(*traced);

        QCOMPARE(map.gaps(), traced->differences.count(Difference::Missing));
        QCOMPARE(map.gaps(), 64);
        QVERIFY(map.isGapAt(10, 1));
        QVERIFY(!map.isGapAt(10, 2));
    }

    void knowsWhichSamplesTrianglesSurround_data()
    {
        QTest::addColumn<int>("x");
        QTest::addColumn<int>("y");
        QTest::addColumn<bool>("surrounded");
        QTest::newRow("inside one") << 10 << 6 << true;
        QTest::newRow("on the shared diagonal") << 10 << 10 << true;
        QTest::newRow("left side") << 4 << 10 << false;
        QTest::newRow("right side") << 16 << 10 << false;
        QTest::newRow("lower side") << 10 << 4 << false;
        QTest::newRow("upper side") << 10 << 16 << false;
        QTest::newRow("end of the diagonal") << 4 << 4 << false;
        QTest::newRow("outside") << 2 << 10 << false;
    }
    void knowsWhichSamplesTrianglesSurround()
    {
        QFETCH(int, x);
        QFETCH(int, y);
        QFETCH(bool, surrounded);

        QCOMPARE(isSurrounded(square(FillRule::Closed).triangles, x, y), surrounded);
    }
};

PIXELPLUMB_TEST(TestOverdraw)

} // namespace tst_overdraw

#include "tst_overdraw.moc"
