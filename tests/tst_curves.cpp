// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/oracle/shapeoracle.h"
#include "tests/support/shapes.h"
#include "tests/support/tracereplay.h"

#include <QRandomGenerator>
#include <QTest>

using namespace pixelplumb;

/// Bézier curves against the truth, and what holds for all curved shapes.
class TestCurves : public QObject {
    Q_OBJECT

private slots:
    void theTruthAtAPixelIsTheTruthOfThePicture()
    {
        QRandomGenerator random(29);
        const auto point = [&] {
            return LatticePoint{random.bounded(-4000, 4000), random.bounded(-4000, 4000)};
        };
        for (int round = 0; round < 24; ++round) {
            const std::vector<Shape> shapes
                = {lineAtUnits(point(), point()),
                   ellipseAtUnits(point(), random.bounded(1, 3000), random.bounded(1, 3000)),
                   ellipseAtUnits(point(), 2000, 2000, ShapeFill::EvenOdd),
                   bezierAt({point(), point(), point()}),
                   bezierAt({point(), point(), point(), point()})};
            const FrameSpec frame = frameOf(32, 32, -16, -16);
            for (const Shape &shape : shapes) {
                const CasePicture truth = truthOf(shape, frame);
                for (std::int64_t y = -16; y < 16; ++y) {
                    for (std::int64_t x = -16; x < 16; ++x)
                        QVERIFY2(oracle::covers(shape, x, y) == truth.isWritten(x, y),
                                 qPrintable(QStringLiteral("seed 29, ") + nameOf(shape)));
                }
            }
        }
    }

    void aStraightCurveIsItsLine()
    {
        const Shape curve
            = bezierAt({latticePixel(2, 3), latticePixel(12, 3), latticePixel(22, 3)});
        const FrameSpec frame = frameOf(30, 8);
        const CasePicture line = truthOf(lineAt(2, 3, 22, 3), frame);
        QCOMPARE(textOf(truthOf(curve, frame)), textOf(line));
        QCOMPARE(textOf(pictureBy(u"bezier-subdivision", curve, frame)), textOf(line));
    }

    void subdivisionNeverLeavesTheTruePixelsByMoreThanOne()
    {
        QRandomGenerator random(41);
        for (int round = 0; round < 60; ++round) {
            std::vector<LatticePoint> controls;
            for (int i = 0; i < 3 + round % 2; ++i)
                controls.push_back({random.bounded(0, 60 * 256), random.bounded(0, 60 * 256)});
            const Shape curve = bezierAt(controls);
            const FrameSpec frame = frameOf(64, 64, -2, -2);
            const CasePicture truth = truthOf(curve, frame);
            const CasePicture drawn = pictureBy(u"bezier-subdivision", curve, frame);
            const auto isNear = [&](const CasePicture &picture, std::int64_t x, std::int64_t y) {
                for (std::int64_t dx = -1; dx <= 1; ++dx) {
                    for (std::int64_t dy = -1; dy <= 1; ++dy) {
                        if (picture.contains(x + dx, y + dy) && picture.isWritten(x + dx, y + dy))
                            return true;
                    }
                }
                return false;
            };
            const QByteArray name = qPrintable(QStringLiteral("seed 41, ") + nameOf(curve));
            drawn.forEachWritten([&](std::int64_t x, std::int64_t y) {
                QVERIFY2(isNear(truth, x, y), name.constData());
            });
            truth.forEachWritten([&](std::int64_t x, std::int64_t y) {
                QVERIFY2(isNear(drawn, x, y), name.constData());
            });
            QVERIFY2(isConnected(drawn), name.constData());
        }
    }

    void hugeCurvesEndTheirSubdivision()
    {
        const Lattice far = largestCoordinate;
        const Shape curve = bezierAt({{-far, -far}, {far, -far}, {-far, far}, {far, far}});
        const FrameSpec frame = frameOf(64, 64, -32, -32);
        const CasePicture drawn = pictureBy(u"bezier-subdivision", curve, frame);
        const CasePicture truth = truthOf(curve, frame);
        QVERIFY(drawn.isWritten(0, 0));
        QVERIFY(truth.isWritten(0, 0));
    }

    void tracingChangesNothing_data() { addMethodsOf(MethodFamily::Curves); }
    void tracingChangesNothing()
    {
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        Scene scene;
        scene.frame = frameOf(60, 50, -10, -5);
        scene.method = method.toStdString();
        scene.settings.arithmetic = arithmetic;
        scene.shapes = {circleAt(10, 9, 12),
                        ellipseAtUnits({5000, 3000}, 4000, 900),
                        circleAt(40, 20, 9, ShapeFill::NonZero),
                        ellipseAtUnits({-300, 3000}, 900, 4000, ShapeFill::EvenOdd),
                        bezierAt({{0, 0}, {9000, 3000}, {-900, 9000}}),
                        bezierAt({{0, 9000}, {9000, 13000}, {-900, -9000}, {11000, 8000}}),
                        circleAt(1000, 1000, 3)};
        FrameBuffer drawn(scene.frame);
        drawScene(scene, drawn);

        const auto traced = traceScene(scene);

        const ScanTrace &trace = *traced->trace;
        QCOMPARE(replayed(trace, scene.frame), drawn.copy());
        QVERIFY(trace.writtenCount() > 0);
        for (std::size_t span = 0; span < trace.spanCount(); ++span) {
            QCOMPARE(trace.span(span).cells.size(), traced->method->spanColumns.size());
            QCOMPARE(trace.samples(span).size(),
                     trace.endSampleOf(span) - trace.firstSampleOf(span));
        }
        for (std::size_t primitive = 0; primitive < scene.shapes.size(); ++primitive) {
            const bool draws = traced->method->draws(scene.shapes[primitive]);
            const auto rejection = trace.setUp(primitive).rejection;
            QCOMPARE(rejection == PrimitiveRejection::NotOfThisMethod, !draws);
            QCOMPARE(trace.setUp(primitive).cells.size(), traced->method->setUpColumns.size());
        }
    }
};

QTEST_GUILESS_MAIN(TestCurves)
#include "tst_curves.moc"
