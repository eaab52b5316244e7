// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/scenetracer.h"

#include <QtTest>

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

    void theFinishedPictureIsJudged()
    {
        QCOMPARE(verdictNote(*traceScene(Scene())), QString());

        Scene scene = defaultSceneIn(Arithmetic::Exact);
        QCOMPARE(verdictNote(*traceScene(scene)), u"When finished: all pixels correct"_s);
        scene.appearance.forced[Effect::Depth] = Forcing::On;
        QCOMPARE(verdictNote(*traceScene(scene)),
                 u"as forced: When finished: all pixels correct"_s);

        const auto rounded = traceScene(defaultSceneIn(Arithmetic::Fixed16));
        QVERIFY(rounded->differences.total() > 0);
        QCOMPARE(verdictNote(*rounded),
                 u"When finished: %1 px wrong; the exact picture has %2 px"_s
                     .arg(rounded->differences.total())
                     .arg(traceScene(scene)->truePixels));
    }

    void whatAMethodRefusesIsWrong()
    {
        Scene scene;
        scene.method = "polygon-fan";
        Shape arrow; // not convex
        arrow.kind = PrimitiveKind::Polygon;
        arrow.fill = ShapeFill::EvenOdd;
        for (const LatticePoint &corner :
             {latticePixel(1, 1), latticePixel(9, 1), latticePixel(3, 3), latticePixel(1, 9)})
            arrow.vertices.push_back({corner, {{255, 0, 0}}});
        scene.shapes = {arrow};

        const auto refused = traceScene(scene);
        QCOMPARE(
            verdictNote(*refused),
            u"When finished: %1 px wrong; the exact picture has %1 px"_s.arg(refused->truePixels));
        scene.method = "polygon-parity";
        QCOMPARE(verdictNote(*traceScene(scene)), u"When finished: all pixels correct"_s);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowTracing)

} // namespace tst_windowtracing

#include "tst_windowtracing.moc"
