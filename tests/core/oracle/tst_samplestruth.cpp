// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/squarearea.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/effectslope.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QTest>

namespace tst_samplestruth {

using namespace pixelplumb;

namespace {

/// A white, opaque area x <= edge (lattice units) that covers the pixels around the origin.
Primitives leftHalf(Lattice edge, Antialiasing antialiasing)
{
    const Lattice far = 1024 * unitsPerPixel;
    Primitives primitives;
    primitives.triangles = {{{{{{edge, -far}, white}, {{edge, far}, white}, {{-far, 0}, white}}}}};
    primitives.appearance.antialiasing = antialiasing;
    return primitives;
}

int redOfOrigin(const Primitives &primitives, FillRule rule = FillRule::Closed)
{
    const FrameBuffer frame
        = truthOver(primitives, frameOf(3, 1, -1, 0), {Arithmetic::Exact, rule});
    return pixelOf(frame, 0, 0).red();
}

} // namespace

/// The truth of antialiasing against values worked out by hand.
class TestSamplesTruth : public QObject {
    Q_OBJECT

private slots:
    void aHalfCoveredPixelHasHalfTheColour()
    {
        const Primitives half = leftHalf(0, Antialiasing::Area);
        QCOMPARE(sampleOf(half, 0, 0).area, Quantity::rational(1, 2));
        QCOMPARE(sampleOf(half, 0, 0).sharedAlpha, std::uint8_t(128)); // 127.5
        QCOMPARE(redOfOrigin(half), 128);
        // The edge lies on the pixel's left side, then on its right side.
        QCOMPARE(redOfOrigin(leftHalf(-halfPixel, Antialiasing::Area)), 0);
        QCOMPARE(redOfOrigin(leftHalf(halfPixel, Antialiasing::Area)), 255);
        QCOMPARE(redOfOrigin(leftHalf(halfPixel - 1, Antialiasing::Area)), 254); // 255 - 0.996
        QCOMPARE(redOfOrigin(leftHalf(1 - halfPixel, Antialiasing::Area)), 1);
    }

    void thePartsOfATriangleInAllPixelsSumToItsArea()
    {
        QRandomGenerator random(20);
        const auto coordinate
            = [&](Lattice extent) { return Lattice(random.bounded(int(2 * extent + 1))) - extent; };
        for (int i = 0; i < 40; ++i) {
            const Lattice thickness = i % 4 == 0 ? 3 : 1500; // slivers too
            const LatticePoint a = {coordinate(1500), coordinate(1500)};
            const LatticePoint b = {coordinate(1500), coordinate(1500)};
            const Triangle triangle
                = triangleAtUnits(a, b, {a.x + coordinate(thickness), a.y + coordinate(thickness)});
            BigRational sum = 0;
            for (std::int64_t y = -13; y <= 13; ++y) {
                for (std::int64_t x = -13; x <= 13; ++x)
                    sum += oracle::areaInSquare(triangle, x, y);
            }
            const BigInteger whole = absolute(doubledArea(triangle));
            QVERIFY2(sum == BigRational(whole, 2 * unitsPerPixel * unitsPerPixel),
                     qPrintable(QString::number(i)));
        }
    }

    void samplesOfAHalfPlaneAreCounted_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::addColumn<Lattice>("edge");
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<int>("level");
        const auto four = Antialiasing::Samples4;
        const auto sixteen = Antialiasing::Samples16;
        QTest::newRow("2 of 4") << four << Lattice(0) << FillRule::Closed << 128; // 127.5
        QTest::newRow("3 of 4") << four << Lattice(64) << FillRule::Closed << 191; // 191.25
        QTest::newRow("4 of 4") << four << halfPixel << FillRule::Closed << 255;
        QTest::newRow("0 of 4") << four << -halfPixel << FillRule::Closed << 0;
        QTest::newRow("one on the edge") << four << Lattice(-96) << FillRule::Closed << 64; // 63.75
        QTest::newRow("one on the edge, open") << four << Lattice(-96) << FillRule::Open << 0;
        // Left of 0 are -1 -3 -5 -2 -4 -6 -8 -7, and 0 itself.
        QTest::newRow("9 of 16") << sixteen << Lattice(0) << FillRule::Closed << 143; // 143.44
        QTest::newRow("8 of 16") << sixteen << Lattice(0) << FillRule::Open << 128; // 127.5
        QTest::newRow("1 of 16") << sixteen << Lattice(-128) << FillRule::Closed << 16; // 15.94
    }
    void samplesOfAHalfPlaneAreCounted()
    {
        QFETCH(Antialiasing, antialiasing);
        QFETCH(Lattice, edge);
        QFETCH(FillRule, rule);
        QFETCH(int, level);
        QCOMPARE(redOfOrigin(leftHalf(edge, antialiasing), rule), level);
    }

    void aPixelHasSeveralSamplesWhereAnEdgeMeetsItsSquare()
    {
        const Triangle triangle = slope(white);
        // Row -1 does not touch the edge y = 0, row 0 does; the diagonal x + y = 16 touches the
        // square around (9, 8) at its corner (8.5, 7.5).
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 4, -1));
        QVERIFY(oracle::edgeMeetsSquare(triangle, 4, 0));
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 4, 1));
        QVERIFY(oracle::edgeMeetsSquare(triangle, 9, 8));
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 9, 9));
        QVERIFY(oracle::edgeMeetsSquare(triangle, 16, 0));
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 17, 0)); // only the edge's line continues there
        const Triangle touching = triangleAtUnits({128, 5}, {900, 900}, {900, 0});
        QVERIFY(oracle::edgeMeetsSquare(touching, 0, 0)); // at one point of its side
    }

    void samplesHaveDepthsAndColoursOfTheirOwn()
    {
        // z = x/16 passes z = 1/2 between the samples of pixel 8, which an edge (y = 0) meets; at y
        // = 0 the samples of the lower half are outside both triangles.
        std::array<VertexAttributes, 3> rising;
        rising[1].z = attributeOne;
        Primitives primitives = oneSlope(atDepth(attribute(1, 2)), {{0, 200, 0}});
        addSlope(primitives, rising, {{200, 0, 0}});
        primitives.appearance.antialiasing = Antialiasing::Samples4;
        const FrameBuffer frame = truthOver(primitives, frameOf(17, 2));
        // Of the samples (-96, 32) and (32, 96) the first is nearer than 1/2, the second is not.
        QCOMPARE(pixelOf(frame, 8, 0), (Colour{{50, 50, 0}}));
        QCOMPARE(pixelOf(frame, 8, 1), (Colour{{200, 0, 0}})); // one sample, and the later triangle
                                                               // shows
    }
};

PIXELPLUMB_TEST(TestSamplesTruth)

} // namespace tst_samplestruth

#include "tst_samplestruth.moc"
