// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "tests/support/shapes.h"
#include "tests/support/tracereplay.h"

#include <QRandomGenerator>
#include <QTest>

using namespace pixelplumb;

/// What draws Bézier curves against the truth, and what holds for all methods of curved shapes.
class TestCurves : public QObject {
    Q_OBJECT

private slots:
    void aStraightCurveIsItsLine()
    {
        const Shape curve
            = bezierAt({latticePixel(2, 3), latticePixel(12, 3), latticePixel(22, 3)});
        const FrameSpec frame = frameOf(30, 8);
        const CasePicture line = truthOf(lineAt(2, 3, 22, 3), frame);
        QCOMPARE(textOf(truthOf(curve, frame)), textOf(line));
        QCOMPARE(textOf(pictureBy(u"bezier-subdivision", curve, frame)), textOf(line));
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
            QCOMPARE(trace.span(span).cells.size(), traced->method->numbers.span.size());
            QCOMPARE(trace.samples(span).size(),
                     trace.endSampleOf(span) - trace.firstSampleOf(span));
        }
        for (std::size_t primitive = 0; primitive < scene.shapes.size(); ++primitive) {
            const bool draws = traced->method->draws(scene.shapes[primitive]);
            const auto rejection = trace.setUp(primitive).rejection;
            QCOMPARE(rejection == PrimitiveRejection::NotOfThisMethod, !draws);
            QCOMPARE(trace.setUp(primitive).cells.size(), traced->method->numbers.setUp.size());
        }
    }
};

QTEST_GUILESS_MAIN(TestCurves)
#include "tst_curves.moc"
