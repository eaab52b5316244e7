// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/scenetext.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QTest>

namespace tst_scenereader {

using namespace pixelplumb;

/// What the reader makes of a scene.
class TestSceneReader : public QObject {
    Q_OBJECT

private slots:
    void readsTheExampleOfTheFormat()
    {
        const Result<SceneReading> reading = readScene(
            "{ \"pixelplumb\": 1, "
            "\"frame\": { \"width\": 64, \"height\": 48, \"background\": \"#f02030\", \"origin\": "
            "\"top-left\", "
            "\"pixelCentre\": \"half\", \"firstPixel\": [-3, 7] }, "
            "\"fillRule\": \"half-open-column\", \"arithmetic\": \"fixed16.16\", \"rounding\": "
            "\"truncate\", "
            "\"method\": \"column-scan\", "
            "\"primitives\": [ { \"triangle\": [[4, 5], [58, 12.25], [\"53/2\", \"44\"]], "
            "\"colors\": [\"#ff0000\", \"#F0FF00\", \"#f000ffff\"] } ] }");

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        Scene expected;
        expected.frame = {64, 48, {{240, 32, 48}}, FrameOrigin::TopLeft, PixelCentre::Half, -3, 7};
        expected.settings = {Arithmetic::Fixed16, FillRule::HalfOpenColumn, ByteRounding::Truncate};
        expected.triangles = {{{{{latticePixel(4, 5), {{255, 0, 0}}},
                                 {{58 * 256, 12 * 256 + 64}, {{240, 255, 0}}},
                                 {{26 * 256 + 128, 44 * 256}, {{240, 0, 255}}}}}}};
        QCOMPARE(reading->scene, expected);
        QVERIFY(reading->snaps.empty());
    }

    void givesDefaultsToWhatIsLeftOut()
    {
        const Result<SceneReading> reading = readScene(
            R"({ "pixelplumb": 1, "frame": { "width": 3, "height": 2 }, "primitives": [] })");

        QVERIFY(reading.isOk());
        Scene expected;
        expected.frame.width = 3;
        expected.frame.height = 2;
        QCOMPARE(reading->scene, expected);
    }

    void readsTheOffScreenPointInTheScenesCoordinates()
    {
        const Result<SceneReading> reading
            = readScene(sceneWith(R"("offScreenPoint": [-3, "13/2"], "primitives": [])"));

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        const std::optional<LatticePoint> point = reading->scene.frame.offScreenPoint;
        QVERIFY(point.has_value());
        QCOMPARE(*point, (LatticePoint{-3 * unitsPerPixel, 13 * halfPixel}));
        QCOMPARE(errorOf(sceneWith(R"("offScreenPoint": [1], "primitives": [])")),
                 u"line 4, column 19, offScreenPoint: an array of 1; expected an "
                 "array of 2"_s);
    }

    void reportsEachVertexThatWasSnapped()
    {
        const Result<SceneReading> reading = readScene(sceneOfTriangleAt("12.1"));

        QVERIFY(reading.isOk());
        QCOMPARE(reading->snaps.size(), std::size_t(1));
        QCOMPARE(reading->snaps.front().message(),
                 u"primitives[0].triangle[0][0]: 12.1 is drawn at 1549/128, displaced by "
                 "1/640 px"_s);
    }

    void aDisplacementBelowAllDoublesIsNotToldAsTheSmallest()
    {
        const Result<SceneReading> reading = readScene(sceneOfTriangleAt("1e-400"));

        QCOMPARE(reading->snaps.front().message(),
                 u"primitives[0].triangle[0][0]: 1e-400 is drawn at 0, displaced by "
                 "less than 1e-300 px"_s);
    }

    void opensEveryTeachingScene_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder(resource(u"/scenes"_s));
        const QStringList names = folder.entryList({u"*.json"_s});
        QVERIFY(names.size() >= 5);
        for (const QString &name : names)
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
    void opensEveryTeachingScene()
    {
        QFETCH(QString, path);

        const Result<SceneReading> reading = readSceneFile(path);

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        QVERIFY(reading->snaps.empty());
        QVERIFY(!reading->scene.isEmpty());
    }
};

PIXELPLUMB_TEST(TestSceneReader)

} // namespace tst_scenereader

#include "tst_scenereader.moc"
