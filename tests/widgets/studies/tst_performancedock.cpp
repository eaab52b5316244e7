// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/scenetiming.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/cost/performancepanel.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_performancedock {

using namespace pixelplumb;

namespace {

constexpr int longest = 30'000; // ms; a measurement takes some tenths of a second

Scene sceneOf(const std::vector<Triangle> &triangles)
{
    Scene scene;
    scene.frame.width = 200;
    scene.frame.height = 120;
    scene.triangles = triangles;
    return scene;
}

Scene twoTriangles()
{
    return sceneOf({triangleAt(3, 4, 150, 20, 60, 110), triangleAt(20, 90, 190, 100, 100, 5)});
}

} // namespace

/// The dock that measures.
class TestPerformanceDock : public QObject {
    Q_OBJECT

private slots:
    void measuresWhenAskedToAndForgetsItForAnotherScene()
    {
        Playhead playhead;
        PerformancePanel panel(&playhead);
        panel.show();
        auto *measure = named<QPushButton>(panel, "performanceMeasure");
        QVERIFY(!measure->isEnabled()); // there is no scene yet
        playhead.setTraced(traceScene(twoTriangles()));
        QVERIFY(measure->isEnabled());
        QVERIFY(!panel.timing());

        QSignalSpy spy(&panel, &PerformancePanel::measured);
        QTest::mouseClick(measure, Qt::LeftButton);
        QVERIFY(panel.isRunning());
        QVERIFY(spy.wait(longest));

        QVERIFY(panel.timing());
        QVERIFY(panel.timing()->sameBytes);
        QVERIFY(panel.timing()->rounds > 0);
        const QString routes = named<QLabel>(panel, "performanceRoutes")->text();
        QVERIFY2(routes.contains(u"strips of "_s), qPrintable(routes));

        playhead.setTraced(traceScene(sceneOf({triangleAt(3, 4, 50, 20, 6, 110)})));
        QVERIFY(!panel.timing());
    }

    void stopsWhenCancelled()
    {
        Playhead playhead;
        playhead.setTraced(traceScene(twoTriangles()));
        PerformancePanel panel(&playhead);
        panel.show();
        QSignalSpy spy(&panel, &PerformancePanel::measured);
        panel.measure();
        auto *cancel = named<QPushButton>(panel, "performanceCancel");
        QVERIFY(cancel->isVisible());
        QTest::mouseClick(cancel, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.isRunning(), longest);
        QVERIFY(!panel.timing());
        QCOMPARE(spy.size(), 0);
        QVERIFY(!cancel->isVisible());
        QVERIFY(named<QPushButton>(panel, "performanceMeasure")->isEnabled());
    }

    void endsWhereItsProgressSaysSo()
    {
        TimingOptions options;
        int calls = 0;
        options.progress = [&calls](const JobProgress &) { return ++calls < 5; };
        QVERIFY(!timeScene(twoTriangles(), options));
        QCOMPARE(calls, 5);
    }

    void countsThePixelsOfTheTrace_data()
    {
        QTest::addColumn<FillRule>("rule");
        QTest::newRow("closed") << FillRule::Closed;
        QTest::newRow("half-open column") << FillRule::HalfOpenColumn;
    }
    void countsThePixelsOfTheTrace()
    {
        QFETCH(FillRule, rule);
        Scene scene = twoTriangles();
        scene.triangles.push_back(triangleAt(-50, -20, 30, 400, 10, 7)); // crosses the border
        scene.triangles.push_back(triangleAt(7, 7, 7, 9, 7, 30)); // a segment
        scene.settings.fillRule = rule;
        TimingOptions options;
        options.rounds = 1;
        options.sampleNanoseconds = 1;
        const std::optional<SceneTiming> timing = timeScene(scene, options);
        QVERIFY(timing);
        QCOMPARE(timing->triangles, scene.triangles.size());
        QCOMPARE(timing->pixels, std::uint64_t(traceScene(scene)->trace->writtenCount()));
        QVERIFY(timing->sameBytes);
    }

    void timesNothingWithoutPixels()
    {
        const std::optional<SceneTiming> empty = timeScene(sceneOf({}), {});
        QVERIFY(empty);
        QCOMPARE(empty->rounds, 0);
        const std::optional<SceneTiming> outside
            = timeScene(sceneOf({triangleAt(-9, -9, -5, -9, -5, -4)}), {});
        QVERIFY(outside);
        QCOMPARE(outside->pixels, std::uint64_t(0));
        QCOMPARE(outside->rounds, 0);
    }

    void takesTheMedianAndTheQuartiles()
    {
        QCOMPARE(spreadOf({5, 1, 4, 2, 3}), (Spread{2, 3, 4}));
        QCOMPARE(spreadOf({7}), (Spread{7, 7, 7}));
        QCOMPARE(spreadOf({1, 2}), (Spread{1.25, 1.5, 1.75}));
    }
};

PIXELPLUMB_TEST(TestPerformanceDock)

} // namespace tst_performancedock

#include "tst_performancedock.moc"
