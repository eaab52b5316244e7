// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/openwindow.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/scenetracer.h"

#include <QSignalSpy>
#include <QTest>

namespace tst_windowtracing {

using namespace pixelplumb;

namespace {

Scene largeScene()
{
    Scene scene;
    scene.frame = frameOf(1500, 1500);
    scene.triangles = {triangleAt(0, 0, 1499, 0, 700, 1499)};
    return scene;
}

} // namespace

/// Scenes too large to be traced between two repaints.
class TestWindowTracing : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void aLargeSceneIsTracedInTheBackground()
    {
        const auto window = openedWindow(Scene());
        QSignalSpy started(&window->parts().tracer->job(), &Job::started);
        QSignalSpy traced(window->parts().tracer, &SceneTracer::traced);
        const Scene scene = largeScene();
        window->parts().document->reset(scene);

        QCOMPARE(started.size(), 1);
        QVERIFY(named<QWidget>(*window, "traceProgress")->isVisible());
        QVERIFY(traced.wait(60'000));
        QVERIFY(!named<QWidget>(*window, "traceProgress")->isVisible());
        QVERIFY(window->parts().playhead->traced()->scene == scene);
    }

    void tracingCanBeCancelledAndTheNewestRequestWins()
    {
        const auto window = openedWindow(Scene());
        SceneTracer &tracer = *window->parts().tracer;
        QSignalSpy cancelled(&tracer, &SceneTracer::cancelled);
        QSignalSpy traced(&tracer, &SceneTracer::traced);
        const Scene scene = largeScene();
        window->parts().document->reset(scene);
        QTest::mouseClick(named<QWidget>(*window, "cancelTrace"), Qt::LeftButton);
        QCOMPARE(cancelled.size(), 1);
        QVERIFY(!tracer.isRunning());
        QCOMPARE(traced.size(), 0);

        tracer.trace(scene);
        Scene newer = scene;
        newer.settings.arithmetic = Arithmetic::Float64;
        tracer.trace(newer);
        QVERIFY(traced.wait(60'000));
        QVERIFY(!tracer.isRunning());
        QCOMPARE(traced.size(), 1);
        QCOMPARE(window->parts().playhead->traced()->scene.settings.arithmetic,
                 Arithmetic::Float64);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowTracing)

} // namespace tst_windowtracing

#include "tst_windowtracing.moc"
