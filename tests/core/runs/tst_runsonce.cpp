// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "core/space/projection.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QTest>

/// The linker calls the counted functions in place of planFor() and projectSolids()
/// (tests/CMakeLists.txt).
namespace tst_runsonce {

using namespace pixelplumb;

EffectPlan planForUncounted(const Primitives &primitives, const ScanSettings &settings,
                            const FrameView &frame) asm("__real_" PIXELPLUMB_PLAN_FOR);
EffectPlan planForCounted(const Primitives &primitives, const ScanSettings &settings,
                          const FrameView &frame) asm("__wrap_" PIXELPLUMB_PLAN_FOR);
std::optional<ProjectedSolids> projectUncounted(
    const SpaceScene &scene,
    const ProgressListener &listener) asm("__real_" PIXELPLUMB_PROJECT_SOLIDS);
std::optional<ProjectedSolids> projectCounted(
    const SpaceScene &scene,
    const ProgressListener &listener) asm("__wrap_" PIXELPLUMB_PROJECT_SOLIDS);

namespace {

int plans = 0;
int projections = 0;

} // namespace

EffectPlan planForCounted(const Primitives &primitives, const ScanSettings &settings,
                          const FrameView &frame)
{
    ++plans;
    return planForUncounted(primitives, settings, frame);
}

std::optional<ProjectedSolids> projectCounted(const SpaceScene &scene,
                                              const ProgressListener &listener)
{
    ++projections;
    return projectUncounted(scene, listener);
}

class TestRunsOnce : public QObject {
    Q_OBJECT

private slots:
    void planAndProjectSolidsOnce_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder(resource(u"/scenes"_s));
        for (const QString &name : folder.entryList({u"*.json"_s}))
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
    /// Judged, drawn and traced: from one plan, and from none where nothing calls for more than
    /// colour.
    void planAndProjectSolidsOnce()
    {
        QFETCH(QString, path);
        const Scene scene = readSceneFile(path)->scene;
        plans = projections = 0;
        SceneRun run(scene);
        QCOMPARE(objectionTo(run), QString());
        const FrameBuffer frame(scene.frame);
        QVERIFY(run.draw(frame.view()));
        run.drawTruth(frame.view());
        coverageOf(run);
        const bool isPlanned = run.plan.has_value();
        const bool isExact = scene.settings.arithmetic == Arithmetic::Exact;
        QVERIFY(traceScene(std::move(run)));
        // The exact twin of a rounding run is another run.
        QCOMPARE(plans, !isPlanned ? 0 : isExact ? 1 : 2);
        QCOMPARE(projections, scene.solids.empty() ? 0 : 1);
    }

    void aRunIsPlannedWhereItIsShownThatNothingIsCalledFor()
    {
        const Scene scene = readSceneFile(resource(u"/scenes/default.json"_s))->scene;
        plans = 0;
        const SceneRun run(scene);
        QVERIFY(planOf(run).isPlain());
        QCOMPARE(plans, 1);
    }
};

PIXELPLUMB_TEST(TestRunsOnce)

} // namespace tst_runsonce

#include "tst_runsonce.moc"
