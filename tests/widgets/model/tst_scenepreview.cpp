// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/scenepicture.h"
#include "core/runs/tracedscene.h"
#include "tests/support/sanitized.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "widgets/model/scenetracer.h"

#include <QtTest>

#include <random>

namespace tst_scenepreview {

using namespace pixelplumb;

namespace {

const ProgressListener always;

/// Triangles that overlap each other and the frame's border, some in the background colour.
Scene scatteredScene(unsigned seed, const ScanSettings &settings, const QString &method)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<Lattice> coordinate(-10 * unitsPerPixel, 100 * unitsPerPixel);
    std::uniform_int_distribution<int> level(0, 255);
    Scene scene;
    scene.frame = frameOf(90, 70, 3, -2);
    scene.frame.background = {{20, 30, 40}};
    scene.frame.pixelCentre = seed % 2 == 0 ? PixelCentre::Integer : PixelCentre::Half;
    scene.settings = settings;
    scene.method = method.toStdString();
    for (int i = 0; i < (isSanitized ? 12 : 40); ++i) {
        Triangle triangle;
        for (Vertex &vertex : triangle.vertices) {
            vertex.position = {coordinate(random), coordinate(random)};
            if (i % 4 == 0)
                vertex.colour = scene.frame.background;
            else
                for (auto &each : vertex.colour.channels)
                    each = std::uint8_t(level(random));
        }
        scene.triangles.push_back(triangle);
    }
    return scene;
}

/// The differences as a raster, so that a failed comparison names the first one that two rasters do
/// not share.
QString rasterOf(const DifferenceMap &differences, const FrameSpec &frame)
{
    QString raster;
    for (int y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
        for (int x = frame.firstColumn; x < frame.firstColumn + frame.width; ++x)
            raster += QLatin1Char(".?!c"[int(differences.at(x, y))]);
        raster += QLatin1Char('\n');
    }
    return raster;
}

std::shared_ptr<const Scene> shared(const Scene &scene)
{
    return std::make_shared<const Scene>(scene);
}

/// A scene that is drawn slowly enough for another request to arrive meanwhile.
Scene slowScene()
{
    Scene scene;
    scene.frame = frameOf(1200, 900);
    scene.settings.arithmetic = Arithmetic::Float64; // it has no fast kernel
    scene.triangles.assign(40, triangleAt(0, 0, 1199, 10, 500, 899));
    return scene;
}

} // namespace

class TestScenePreview : public QObject {
    Q_OBJECT

private slots:
    void aPictureAndItsDifferencesAreThoseOfTheTrace_data()
    {
        QTest::addColumn<Scene>("scene");
        unsigned seed = 0;
        for (const Method &method : methods()) {
            for (const Arithmetic arithmetic : method.arithmetics) {
                for (const FillRule rule : method.fillRules) {
                    if (!method.draws(PrimitiveKind::Triangle))
                        continue;
                    ++seed;
                    QTest::addRow("%s, %s, %s, seed %u", qPrintable(method.id),
                                  std::string(nameOf(arithmetic)).c_str(),
                                  std::string(nameOf(rule)).c_str(), seed)
                        << scatteredScene(seed, {arithmetic, rule, ByteRounding::Nearest},
                                          method.id);
                }
            }
        }
    }
    void aPictureAndItsDifferencesAreThoseOfTheTrace()
    {
        QFETCH(Scene, scene);
        const auto traced = traceScene(scene);
        FrameBuffer drawn(scene.frame);
        drawScene(scene, drawn);

        ScenePicture picture(scene.frame);
        QVERIFY(picture.draw(shared(scene), always));

        QVERIFY(picture.drawn().copy() == drawn.copy());
        if (!picture.exactTwin()) {
            QVERIFY(!columnScan().supports(scene.settings.fillRule));
            QCOMPARE(picture.differences().total(), 0);
            return;
        }
        QVERIFY(picture.exactTwin()->copy() == traced->truth.copy());
        QCOMPARE(rasterOf(picture.differences(), scene.frame),
                 rasterOf(traced->differences, scene.frame));
    }

    void coverageAndColoursAreCompared()
    {
        std::int64_t missing = 0;
        std::int64_t extra = 0;
        std::int64_t colour = 0;
        for (const Method &method : methods()) {
            if (!method.draws(PrimitiveKind::Triangle) || !method.supports(FillRule::Closed))
                continue;
            for (const Arithmetic arithmetic : method.arithmetics) {
                // Whole pixels, where ties let rounding decide.
                Scene scene = scatteredScene(
                    2, {arithmetic, FillRule::Closed, ByteRounding::Nearest}, method.id);
                for (Triangle &triangle : scene.triangles) {
                    for (Vertex &vertex : triangle.vertices)
                        vertex.position = latticePixel(floorPixel(vertex.position.x),
                                                       floorPixel(vertex.position.y));
                }
                ScenePicture picture(scene.frame);
                QVERIFY(picture.draw(shared(scene), always));
                missing += picture.differences().count(Difference::Missing);
                extra += picture.differences().count(Difference::Extra);
                colour += picture.differences().count(Difference::Colour);
            }
        }
        QVERIFY(missing + extra > 0);
        QVERIFY(colour > 0);
    }

    void onePictureServesOneSceneAfterAnother()
    {
        const ScanSettings rounding{Arithmetic::Fixed16, FillRule::Closed, ByteRounding::Nearest};
        ScenePicture reused(scatteredScene(0, rounding, "column-scan").frame);
        for (unsigned seed = 2; seed < 12; seed += 2) {
            Scene scene = scatteredScene(seed, rounding, "column-scan");
            if (seed % 4 == 0)
                scene.settings.arithmetic = Arithmetic::Exact;
            scene.frame = reused.spec();
            ScenePicture fresh(scene.frame);
            QVERIFY(reused.draw(shared(scene), always));
            QVERIFY(fresh.draw(shared(scene), always));
            QVERIFY2(reused.drawn().copy() == fresh.drawn().copy(),
                     qPrintable(u"seed %1"_s.arg(seed)));
            QCOMPARE(rasterOf(reused.differences(), scene.frame),
                     rasterOf(fresh.differences(), scene.frame));
        }
    }

    void aDragIsDrawnAsIfFromTheStart_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<unsigned>("seed");
        for (const Arithmetic arithmetic : allArithmetics) {
            for (unsigned seed = 1; seed <= 6; ++seed)
                QTest::addRow("%s, seed %u", std::string(nameOf(arithmetic)).c_str(), seed)
                    << arithmetic << seed;
        }
    }
    void aDragIsDrawnAsIfFromTheStart()
    {
        QFETCH(Arithmetic, arithmetic);
        QFETCH(unsigned, seed);
        Scene scene = scatteredScene(seed, {arithmetic, FillRule::Closed, ByteRounding::Nearest},
                                     "column-scan");
        std::mt19937 random(seed);
        std::uniform_int_distribution<Lattice> way(-9 * unitsPerPixel, 9 * unitsPerPixel);
        std::uniform_int_distribution<std::size_t> which(0, scene.triangles.size() - 1);
        ScenePicture dragged(scene.frame);
        for (int move = 0; move < (isSanitized ? 8 : 40); ++move) {
            LatticePoint &place = scene.triangles[which(random)].vertices[0].position;
            place = {place.x + way(random), place.y + way(random)};
            ScenePicture fresh(scene.frame);
            QVERIFY(dragged.draw(shared(scene), always));
            QVERIFY(fresh.draw(shared(scene), always));
            const QByteArray when = u"move %1"_s.arg(move).toUtf8();
            QVERIFY2(dragged.drawn().copy() == fresh.drawn().copy(), when);
            QVERIFY2(dragged.exactTwin()->copy() == fresh.exactTwin()->copy(), when);
            QCOMPARE(rasterOf(dragged.differences(), scene.frame),
                     rasterOf(fresh.differences(), scene.frame));
            QCOMPARE(dragged.differences().total(), fresh.differences().total());
        }
    }

    void aPictureThatWasLeftHalfDrawnIsDrawnAnew()
    {
        Scene scene = scatteredScene(
            5, {Arithmetic::Float32, FillRule::Closed, ByteRounding::Nearest}, "column-scan");
        ScenePicture picture(scene.frame);
        QVERIFY(picture.draw(shared(scene), always));
        scene.triangles[0].vertices[0].position = latticePixel(1, 60);
        QVERIFY(!picture.draw(shared(scene), [](const JobProgress &) { return false; }));
        QVERIFY(picture.draw(shared(scene), always));
        FrameBuffer drawn(scene.frame);
        drawScene(scene, drawn);
        QVERIFY(picture.drawn().copy() == drawn.copy());
    }

    void shapesAreDrawnAndHaveNoDifferencesToShow()
    {
        Scene scene;
        scene.method = "line-dda";
        scene.settings = methodNamed(u"line-dda")->adapted(scene.settings);
        Shape line;
        line.vertices = {{latticePixel(2, 3), red}, {latticePixel(50, 20), red}};
        scene.shapes = {line, line};
        scene.shapes[1].vertices[1].position = latticePixel(10, 40);
        FrameBuffer drawn(scene.frame);
        drawScene(scene, drawn);

        ScenePicture picture(scene.frame);
        QVERIFY(picture.draw(shared(scene), always));

        QVERIFY(picture.drawn().copy() == drawn.copy());
        QCOMPARE(picture.differences().total(), 0);
    }

    void drawingEndsWhenItIsToldTo()
    {
        const Scene scene = scatteredScene(3, {}, "column-scan");
        ScenePicture picture(scene.frame);
        QVERIFY(!picture.draw(shared(scene), [](const JobProgress &) { return false; }));
    }

    void ofManyRequestsTheNewestIsShownLast()
    {
        ScenePreviewer previewer;
        QSignalSpy changed(&previewer, &ScenePreviewer::pictureChanged);
        Scene scene = slowScene();
        FrameBuffer last(scene.frame);
        for (int request = 0; request < 6; ++request) {
            scene.triangles.back().vertices[0].position = latticePixel(100 * request, 5);
            previewer.preview(shared(scene));
            QVERIFY(previewer.isAheadOfTrace());
        }
        drawScene(scene, last);

        QTRY_VERIFY_WITH_TIMEOUT(!previewer.isRunning(), 60'000);
        QVERIFY(previewer.picture()->drawn().copy() == last.copy());
        QCOMPARE(changed.size(), 2); // the one in progress and the newest
    }

    void aWholeTraceLeavesNothingToShow()
    {
        ScenePreviewer previewer;
        const Scene scene = scatteredScene(1, {}, "column-scan");
        previewer.preview(shared(scene));
        QTRY_VERIFY(previewer.picture());
        previewer.followTrace(traceScene(scene));
        QVERIFY(!previewer.picture());
        QVERIFY(!previewer.isAheadOfTrace());
    }

    void aPictureThatComesAfterTheTraceIsDropped()
    {
        ScenePreviewer previewer;
        const Scene scene = slowScene();
        previewer.preview(shared(scene));
        previewer.followTrace(traceScene(scatteredScene(1, {}, "column-scan")));

        QTRY_VERIFY_WITH_TIMEOUT(!previewer.isRunning(), 60'000);
        QVERIFY(!previewer.picture());
    }

    void aCutTraceLeavesTheFinishedPicture()
    {
        ScenePreviewer previewer;
        const Scene scene = scatteredScene(1, {}, "column-scan");
        TraceOptions options;
        options.sampleLimit = 100;
        const auto traced = traceScene(scene, options);
        QVERIFY(traced->trace->isCut());
        previewer.preview(shared(scene));
        previewer.followTrace(traced);

        QTRY_VERIFY(previewer.picture());
        QVERIFY(!previewer.isAheadOfTrace());
        FrameBuffer whole(scene.frame);
        drawScene(scene, whole);
        QVERIFY(previewer.picture()->drawn().copy() == whole.copy());
    }
};

PIXELPLUMB_TEST(TestScenePreview)

} // namespace tst_scenepreview

#include "tst_scenepreview.moc"
