// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scene/asciiraster.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QtTest>

namespace tst_asciiraster {

using namespace pixelplumb;

namespace {

/// A scene of one triangle in one colour.
Scene sceneOf(std::int32_t width, std::int32_t height, const std::array<LatticePoint, 3> &corners,
              const Colour &colour = {{255, 255, 255}})
{
    Scene scene;
    scene.frame.width = width;
    scene.frame.height = height;
    scene.triangles.resize(1);
    for (std::size_t corner = 0; corner < 3; ++corner)
        scene.triangles.front().vertices[corner] = {corners[corner], colour};
    return scene;
}

const std::array<LatticePoint, 3> rightAngle
    = {latticePixel(1, 1), latticePixel(5, 1), latticePixel(1, 4)};

CoverageMask parsed(const char *text) { return *parseAsciiRaster(QString::fromLatin1(text)); }

} // namespace

class TestAsciiRaster : public QObject {
    Q_OBJECT

private slots:
    void drawsTheTopLineFirst_data()
    {
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<QString>("raster");
        QTest::newRow("y upward") << FrameOrigin::BottomLeft
                                  << ".......\n"
                                     ".#.....\n"
                                     ".##....\n"
                                     ".###...\n"
                                     ".#####.\n"
                                     ".......\n";
        QTest::newRow("y downward") << FrameOrigin::TopLeft
                                    << ".......\n"
                                       ".#####.\n"
                                       ".###...\n"
                                       ".##....\n"
                                       ".#.....\n"
                                       ".......\n";
    }
    void drawsTheTopLineFirst()
    {
        QFETCH(FrameOrigin, origin);
        QFETCH(QString, raster);
        Scene scene = sceneOf(7, 6, rightAngle);
        scene.frame.origin = origin;

        QCOMPARE(asciiRaster(coverageOf(SceneRun(scene))), raster);
    }

    void coversATriangleInTheBackgroundsColour()
    {
        Scene scene = sceneOf(7, 6, rightAngle, {{1, 2, 3}});
        const QString raster = asciiRaster(coverageOf(SceneRun(scene)));
        scene.frame.background = {{1, 2, 3}};

        QCOMPARE(asciiRaster(coverageOf(SceneRun(scene))), raster);
        QVERIFY(raster.contains(u'#'));
    }

    void coversBlackOnBlack()
    {
        const QString raster
            = asciiRaster(coverageOf(SceneRun(sceneOf(7, 6, rightAngle, {{0, 0, 0}}))));

        QCOMPARE(raster.count(u'#'), qsizetype(11));
    }

    void followsTheFramesFirstPixel()
    {
        Scene scene = sceneOf(3, 2, rightAngle);
        scene.frame.firstColumn = 1;
        scene.frame.firstRow = 3;

        QCOMPARE(asciiRaster(coverageOf(SceneRun(scene))), u"#..\n##.\n"_s);
    }

    void readsBackWhatItWrote_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 50; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void readsBackWhatItWrote()
    {
        QFETCH(quint32, seed);
        QRandomGenerator random(seed);
        FrameSpec spec;
        spec.width = random.bounded(1, 40);
        spec.height = random.bounded(1, 40);
        CoverageMask coverage(spec);
        for (int y = 0; y < spec.height; ++y) {
            for (int x = 0; x < spec.width; ++x) {
                if (random.bounded(2) == 0)
                    coverage.cover(x, y);
            }
        }

        const Result<CoverageMask> read = parseAsciiRaster(asciiRaster(coverage));

        QVERIFY(read.isOk());
        QVERIFY(*read == coverage);
    }

    void readsWindowsLinesAndAMissingLastLineFeed()
    {
        QVERIFY(parsed("#.\r\n.#\r\n") == parsed("#.\n.#\n"));
        QVERIFY(parsed("#.\n.#") == parsed("#.\n.#\n"));
    }

    void refusesWhatIsNoRaster_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        QTest::newRow("empty") << ""
                               << "line 1: nothing; expected a line of # and .";
        QTest::newRow("only a line feed") << "\n"
                                          << "line 1: nothing; expected a line of # and .";
        QTest::newRow("ragged") << "##\n###\n"
                                << "line 2: its length is 3; expected 2, as that of the first line";
        QTest::newRow("blank line inside")
            << "##\n\n##\n"
            << "line 2: its length is 0; expected 2, as that of the first line";
        QTest::newRow("other character") << "##\n#x\n"
                                         << "line 2, column 2: “x”; expected # or .";
        QTest::newRow("space") << " #\n"
                               << "line 1, column 1: “ ”; expected # or .";
        QTest::newRow("too wide") << QString(32769, u'#')
                                  << "a raster of 32769 × 1; expected at most 32768 on a side and "
                                     "268435456 pixels";
    }
    void refusesWhatIsNoRaster()
    {
        QFETCH(QString, text);
        QFETCH(QString, message);

        const Result<CoverageMask> read = parseAsciiRaster(text);

        QVERIFY(!read.isOk());
        QCOMPARE(read.error().message(), message);
    }
};

PIXELPLUMB_TEST(TestAsciiRaster)

} // namespace tst_asciiraster

#include "tst_asciiraster.moc"
