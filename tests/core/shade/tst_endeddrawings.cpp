// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/scenepicture.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/plannedtriangles.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <random>

namespace tst_endeddrawings {

using namespace pixelplumb;

namespace {

/// Panes of glass, one on top of the other.
Scene glassScene(Arithmetic arithmetic, Antialiasing antialiasing)
{
    std::mt19937 random(4);
    std::uniform_int_distribution<Lattice> coordinate(-10 * unitsPerPixel, 100 * unitsPerPixel);
    Scene scene;
    scene.frame.width = 90;
    scene.frame.height = 70;
    scene.settings = {arithmetic, FillRule::Closed, ByteRounding::Nearest};
    scene.appearance.antialiasing = antialiasing;
    Primitives panes;
    for (std::size_t i = 0; i < 40; ++i) {
        Triangle &pane = panes.triangles.emplace_back();
        for (Vertex &vertex : pane.vertices)
            vertex = {{coordinate(random), coordinate(random)}, {{255, std::uint8_t(6 * i), 0}}};
        setAlpha(panes, i, 100);
    }
    scene.triangles = panes.triangles;
    scene.attributes = panes.attributes;
    return scene;
}

Scene sphereScene()
{
    Scene scene;
    scene.camera.emplace();
    Solid &sphere = scene.solids.emplace_back();
    sphere.kind = SolidKind::Sphere;
    sphere.corners.resize(1);
    sphere.segments = {64, 32};
    return scene;
}

std::shared_ptr<const Scene> shared(const Scene &scene)
{
    return std::make_shared<const Scene>(scene);
}

} // namespace

/// Drawings with effects, and of solids, that stop when told to.
class TestEndedDrawings : public QObject {
    Q_OBJECT

private slots:
    void anEndedEffectDrawingKeepsItsPixels_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::addColumn<int>("passes"); ///< over the triangles, in both pictures
        const auto add
            = [](const char *name, Arithmetic arithmetic, Antialiasing antialiasing, int passes) {
                  QTest::newRow(name) << arithmetic << antialiasing << passes;
              };
        add("exact", Arithmetic::Exact, Antialiasing::None, 1);
        add("float32 and its twin", Arithmetic::Float32, Antialiasing::None, 2);
        add("4 samples", Arithmetic::Exact, Antialiasing::Samples4, 5);
        add("areas", Arithmetic::Exact, Antialiasing::Area, 1);
    }
    void anEndedEffectDrawingKeepsItsPixels()
    {
        QFETCH(Arithmetic, arithmetic);
        QFETCH(Antialiasing, antialiasing);
        QFETCH(int, passes);
        const Scene scene = glassScene(arithmetic, antialiasing);
        const std::int64_t total = passes * std::int64_t(scene.triangles.size());
        FrameBuffer whole(scene.frame);
        drawScene(scene, whole);

        ScenePicture picture(scene.frame);
        for (const std::int64_t last : {std::int64_t(0), total / 3, total - 1}) {
            std::int64_t told = -1;
            QVERIFY(!picture.draw(shared(scene), [&](const JobProgress &progress) {
                told = progress.done;
                return progress.phase != JobPhase::Drawing || progress.done < last;
            }));
            QCOMPARE(told, last);
            std::vector<std::int64_t> heard;
            QVERIFY(picture.draw(shared(scene), [&](const JobProgress &progress) {
                heard.push_back(progress.done);
                return progress.total == total;
            }));
            QVERIFY(std::ranges::is_sorted(heard));
            QCOMPARE(heard.back(), total - 1);
            QVERIFY(picture.drawn().copy() == whole.copy());
        }
    }

    void projectingSolidsEndsWhenItIsToldTo()
    {
        const Scene scene = sphereScene();
        for (const std::int64_t last : {0, 1000}) {
            std::int64_t told = -1;
            bool wasProjecting = true;
            QVERIFY(
                !ScenePicture(scene.frame).draw(shared(scene), [&](const JobProgress &progress) {
                    wasProjecting &= progress.phase == JobPhase::Projecting;
                    told = progress.done;
                    return progress.done < last;
                }));
            QVERIFY(wasProjecting);
            QVERIFY(told >= last && told < last + 500);
        }
        TraceOptions options;
        options.progress
            = [](const JobProgress &progress) { return progress.phase != JobPhase::Projecting; };
        QVERIFY(!traceScene(scene, options));
    }
};

PIXELPLUMB_TEST(TestEndedDrawings)

} // namespace tst_endeddrawings

#include "tst_endeddrawings.moc"
