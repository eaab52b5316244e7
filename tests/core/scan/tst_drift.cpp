// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/numbernamed.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_drift {

using namespace pixelplumb;

/// The rounding forms fail where resources/numerics.md, 2.1 and 2.2, says so, and are right where
/// it says so: the checks of the exact form can fail.
class TestDrift : public QObject {
    Q_OBJECT

private slots:
    void losesAndInventsPixelsWhereTheBookSays_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<FrameSpec>("frame");
        QTest::addColumn<Triangle>("triangle");
        QTest::addColumn<int>("missing");
        QTest::addColumn<int>("extra");

        const FrameSpec tenths = frameOf(1001, 701);
        QTest::newRow("slopes of tenths: float32")
            << Arithmetic::Float32 << tenths << triangleAt(0, 0, 1000, 100, 1000, 700) << 64 << 0;
        QTest::newRow("slopes of tenths: float64 is worse")
            << Arithmetic::Float64 << tenths << triangleAt(0, 0, 1000, 100, 1000, 700) << 127 << 0;
        QTest::newRow("slopes of tenths: exact")
            << Arithmetic::Exact << tenths << triangleAt(0, 0, 1000, 100, 1000, 700) << 0 << 0;
        const FrameSpec stagnant = frameOf(16385, 19, 0, 19994);
        QTest::newRow("y = 20000 never moves in float32")
            << Arithmetic::Float32 << stagnant << triangleAt(0, 20000, 16384, 20007, 0, 20012) << -1
            << -1;
        QTest::newRow("y = 20000 moves in float64 and may miss ties only")
            << Arithmetic::Float64 << stagnant << triangleAt(0, 20000, 16384, 20007, 0, 20012) << 0
            << 0;
        QTest::newRow("power-of-two widths hide it all")
            << Arithmetic::Float32 << frameOf(1025, 769) << triangleAt(0, 0, 1024, 512, 1024, 768)
            << 0 << 0;
    }
    void losesAndInventsPixelsWhereTheBookSays()
    {
        QFETCH(Arithmetic, arithmetic);
        QFETCH(FrameSpec, frame);
        QFETCH(Triangle, triangle);
        QFETCH(int, missing);
        QFETCH(int, extra);
        Scene scene;
        scene.frame = frame;
        scene.settings.arithmetic = arithmetic;
        scene.triangles = {triangle};
        const auto traced = traceScene(scene);
        if (missing < 0) { // thousands; the exact count depends on the machine's rounding
            QVERIFY(traced->differences.count(Difference::Extra) > 50000);
            return;
        }
        QCOMPARE(traced->differences.count(Difference::Missing), std::int64_t(missing));
        QCOMPARE(traced->differences.count(Difference::Extra), std::int64_t(extra));
    }

    void aLevelThatFloorsBelowZeroIsClampedAndRecorded()
    {
        // 255 → 0 over 300 columns: the rounded rate −55706/65536 ends at −120/65536.
        Scene scene;
        scene.frame = frameOf(301, 41);
        scene.settings = {Arithmetic::Fixed16, FillRule::Closed, ByteRounding::Truncate};
        Triangle triangle = triangleAt(0, 0, 300, 0, 0, 40);
        triangle.vertices[0].colour = red;
        triangle.vertices[1].colour = {};
        triangle.vertices[2].colour = red;
        scene.triangles = {triangle};
        const auto truncated = traceScene(scene);
        const ScanTrace &trace = *truncated->trace;
        QVERIFY(!trace.clampedSamples().empty());
        const std::size_t pixel = trace.clampedSamples().front();
        const std::size_t column = trace.spanOf(pixel);
        const SampleRecord fragment = trace.samples(column)[pixel - trace.firstSampleOf(column)];
        QVERIFY(fragment.clamped);
        QCOMPARE(fragment.level[0], std::int64_t(-1));
        QCOMPARE(qRed(trace.changes()[pixel].after), 0);
        scene.settings.rounding = ByteRounding::Nearest;
        const auto nearest = traceScene(scene);
        QVERIFY(nearest->trace->clampedSamples().empty());
    }

    void noArithmeticDividesZeroByZeroAtATip()
    {
        for (const Arithmetic arithmetic : allArithmetics) {
            Scene scene;
            scene.settings.arithmetic = arithmetic;
            scene.triangles = {triangleAt(2, 5, 12, 1, 12, 11)};
            const auto traced = traceScene(scene);
            const SpanRecord tip = traced->trace->span(0);
            QCOMPARE(tip.lower, tip.upper);
            for (const QChar letter : channelLetters)
                QVERIFY(spanNumber(*traced, 0, u"first_"_s + letter).isFinite());
            QCOMPARE(traced->trace->changes()[0].after, packed(red));
        }
    }
};

PIXELPLUMB_TEST(TestDrift)

} // namespace tst_drift

#include "tst_drift.moc"
