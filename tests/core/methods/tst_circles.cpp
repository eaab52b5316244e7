// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scan/curves/circlemidpoint.h"
#include "core/scan/curves/circleshape.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>

namespace tst_circles {

using namespace pixelplumb;

namespace {

/// A frame that holds a round shape with some room.
FrameSpec frameAround(const Shape &shape)
{
    const LatticePoint centre = shape.vertices[0].position;
    const LatticePoint corner = shape.vertices[1].position;
    const auto radiusX = std::int32_t(ceilPixel(corner.x - centre.x)) + 2;
    const auto radiusY = std::int32_t(ceilPixel(corner.y - centre.y)) + 2;
    return frameOf(2 * radiusX + 1, 2 * radiusY + 1, std::int32_t(floorPixel(centre.x)) - radiusX,
                   std::int32_t(floorPixel(centre.y)) - radiusY);
}

} // namespace

/// Circles and ellipses against the truth, the texts and their own decisions.
class TestCircles : public QObject {
    Q_OBJECT

private slots:
    void halfAChordIsTheLargestLatticeLengthWithinIt()
    {
        QRandomGenerator random(3);
        const auto upTo = [&random](Lattice largest) {
            return Lattice(random.generate64() % std::uint64_t(largest + 1));
        };
        for (int round = 0; round < 4000; ++round) {
            const Lattice largest = Lattice(1) << (1 + round % 39);
            const Lattice a = 1 + upTo(largest);
            const Lattice b = upTo(largest);
            // A chord grows fastest near the end of the axis.
            const Lattice distance = round % 2 == 0 ? upTo(a) : a - upTo(std::min<Lattice>(a, 3));
            const Lattice half = halfChord(a, b, distance);
            const auto square = [](Int256 number) { return Int256(number * number); };
            const Int256 chord = square(b) * (square(a) - square(distance));
            QVERIFY(half >= 0 && square(a) * square(half) <= chord);
            QVERIFY(square(a) * square(half + 1) > chord);
        }
        QCOMPARE(halfChord(0, 7, 0), Lattice(7));
        QCOMPARE(halfChord(5, 5, 3), Lattice(4));
        QCOMPARE(halfChord(5, 5, -5), Lattice(0));
    }

    void theSmallestCirclesAreTheTruth_data()
    {
        QTest::addColumn<int>("radius");
        QTest::addColumn<QString>("picture");
        QTest::newRow("a point") << 0 << ".....\n.....\n..#..\n.....\n.....\n";
        QTest::newRow("1") << 1 << "...\n.#.\n#.#\n.#.\n...\n";
        QTest::newRow("2") << 2 << ".###.\n#...#\n#...#\n#...#\n.###.\n";
        QTest::newRow("3") << 3
                           << "..###..\n.#...#.\n#.....#\n#.....#\n#.....#\n.#...#.\n..###..\n";
    }
    void theSmallestCirclesAreTheTruth()
    {
        QFETCH(int, radius);
        QFETCH(QString, picture);
        const int reach = radius == 0 ? 2 : radius;
        const FrameSpec frame = radius == 1 ? frameOf(3, 5, -1, -2)
                                            : frameOf(2 * reach + 1, 2 * reach + 1, -reach, -reach);

        QCOMPARE(textOf(truthOf(circleAt(0, 0, radius), frame)), picture);
    }

    void midpointCirclesAreTheTruthUpToRadius200()
    {
        for (int radius = 0; radius <= 200; ++radius) {
            const Shape circle = circleAt(3, -4, radius);
            const FrameSpec frame = frameAround(circle);
            const CasePicture truth = truthOf(circle, frame);
            const QString departed = departure(pictureBy(u"circle-midpoint", circle, frame), truth);
            QVERIFY2(departed.isEmpty(), qPrintable(u"radius %1: "_s.arg(radius) + departed));
            QVERIFY2(radius > 60 || isConnected(truth), qPrintable(QString::number(radius)));
        }
    }

    void midpointEllipsesAreTheTruth()
    {
        for (int a = 0; a <= 40; ++a) {
            for (int b = 0; b <= 40; ++b) {
                const Shape ellipse = ellipseAtUnits(latticePixel(2, 5), a * 256, b * 256);
                const FrameSpec frame = frameAround(ellipse);
                const QString departed = departure(pictureBy(u"circle-midpoint", ellipse, frame),
                                                   truthOf(ellipse, frame));
                QVERIFY2(departed.isEmpty(), qPrintable(u"%1 × %2: "_s.arg(a).arg(b) + departed));
            }
        }
    }

    void decisionsOfTheMidpointCircleAreTheTextbooks()
    {
        const auto traced
            = traceScene(sceneOf(circleAt(20, 20, 10), "circle-midpoint", frameOf(41, 41)));

        // p₀ = 5/4 − r; p grows by 2x + 1, and by 2y less where the row goes down.
        QStringList decisions;
        QStringList places;
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            const std::vector<Quantity> cells = traced->trace->span(span).cells;
            places.append(toText(cells[2]) + u',' + toText(cells[3]));
            decisions.append(toText(cells[5]));
        }
        QCOMPARE(places.join(u' '), u"0,10 1,10 2,10 3,10 4,9 5,9 6,8 7,7"_s);
        QCOMPARE(decisions.mid(0, 7).join(u' '), u"-8 3/4 -5 3/4 -3/4 6 1/4 -2 3/4 8 1/4 5 1/4"_s);
    }

    void decisionsGrowToWhatTheirFormulaSays()
    {
        for (const auto &[a, b] : {std::pair(50, 50), std::pair(90, 7), std::pair(7, 90)}) {
            const MidpointArc arc = {a, b};
            MidpointStep step = midpointStepAt(arc, 0, 0);
            for (; arc.reaches(step.x); advance(arc, step)) {
                QVERIFY(step.nextDecision == arc.decision(step.x + 1, step.y));
                QCOMPARE(midpointStepAt(arc, 0, step.x).y, step.y);
            }
        }
    }

    void filledCirclesAreTheTruthAnywhere()
    {
        QRandomGenerator random(17);
        for (int round = 0; round < 200; ++round) {
            const Shape shape = ellipseAtUnits(
                {random.bounded(-5000, 5000), random.bounded(-5000, 5000)}, random.bounded(1, 6000),
                random.bounded(1, 6000), ShapeFill::NonZero);
            const FrameSpec frame = frameAround(shape);
            QVERIFY2(
                departure(pictureBy(u"circle-fill", shape, frame), truthOf(shape, frame)).isEmpty(),
                qPrintable(u"seed 17, "_s + nameOf(shape)));
        }
    }

    void aFilledCircleHoldsTheSamplesWithinItsRadius()
    {
        // Gauss's circle problem: 317 lattice points within 10 of the centre.
        QCOMPARE(pictureBy(u"circle-fill", circleAt(0, 0, 10, ShapeFill::NonZero),
                           frameOf(41, 41, -20, -20))
                     .pixelCount(),
                 std::int64_t(317));
    }

    void theExplicitFormHasGapsWhereItIsSteepAndIsRightElsewhere()
    {
        const Shape circle = circleAt(0, 0, 20);
        const FrameSpec frame = frameAround(circle);
        const CasePicture truth = truthOf(circle, frame);
        for (const Arithmetic arithmetic :
             {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64}) {
            const CasePicture drawn = pictureBy(u"circle-explicit", circle, frame, arithmetic);
            QVERIFY(differencesBetween(drawn, truth).count(Difference::Missing) > 10);
            for (std::int64_t x = -14; x <= 14; ++x) { // 20/√2 = 14.1
                for (std::int64_t y = -20; y <= 20; ++y)
                    QCOMPARE(drawn.isWritten(x, y), truth.isWritten(x, y) && absolute(y) >= 14);
            }
        }
    }

    void theParametricFormComesWithinAPixelEverywhere()
    {
        for (const Arithmetic arithmetic : {Arithmetic::Float32, Arithmetic::Float64}) {
            const Shape circle = circleAt(0, 0, 40);
            const FrameSpec frame = frameAround(circle);
            const CasePicture drawn = pictureBy(u"circle-parametric", circle, frame, arithmetic);
            QVERIFY(isConnected(drawn));
            drawn.forEachWritten([](std::int64_t x, std::int64_t y) {
                const double radius = std::sqrt(double(x * x + y * y));
                QVERIFY(std::abs(radius - 40) < 0.75);
            });
        }
    }

    void hugeCirclesAreDrawnWhereTheyPassTheFrame()
    {
        const std::int64_t far = std::int64_t(1) << 29;
        const Shape circle = circleAt(far, 8, far);
        const FrameSpec frame = frameOf(40, 40, -4, -12);
        const CasePicture truth = truthOf(circle, frame);
        QCOMPARE(truth.pixelCount(), std::int64_t(40)); // the column x = 0, practically straight
        QVERIFY(departure(pictureBy(u"circle-midpoint", circle, frame), truth).isEmpty());
        QVERIFY(
            departure(pictureBy(u"circle-parametric", circle, frame, Arithmetic::Float64), truth)
                .isEmpty());
        const Shape filled = circleAt(far, 8, far, ShapeFill::NonZero);
        QVERIFY(
            departure(pictureBy(u"circle-fill", filled, frame), truthOf(filled, frame)).isEmpty());
    }
};

PIXELPLUMB_TEST(TestCircles)

} // namespace tst_circles

#include "tst_circles.moc"
