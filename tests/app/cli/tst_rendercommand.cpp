// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scene/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QImage>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <unistd.h>

namespace tst_rendercommand {

using namespace pixelplumb;

/// Pictures and rasters from the command line.
class TestRenderCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void refusesScenesThatNoFrameCanHold_data()
    {
        QTest::addColumn<QByteArray>("scene");
        QTest::addColumn<QString>("message");
        QTest::newRow("width 0") << sceneOfSize(0, 5)
                                 << "frame.width: 0; expected an integer from 1 to 32768";
        QTest::newRow("height 0") << sceneOfSize(5, 0) << "frame.height: 0; expected";
        QTest::newRow("width 32769") << sceneOfSize(32769, 5) << "frame.width: 32769; expected";
        QTest::newRow("2^30 pixels")
            << sceneOfSize(32768, 32768) << "expected at most 268435456 pixels";
        QTest::newRow("nan") << QByteArray(sceneOfSize(5, 5)).replace("90000, 0", "\"nan\", 0")
                             << "primitives[0].triangle[1][0]: “nan” is no coordinate";
        QTest::newRow("infinity") << QByteArray(sceneOfSize(5, 5)).replace("90000, 0", "\"inf\", 0")
                                  << "“inf” is no coordinate";
        QTest::newRow("3e9") << QByteArray(sceneOfSize(5, 5)).replace("90000, 0", "3e9, 0")
                             << "3e9 is outside ±1073741824 px";
        QTest::newRow("newer")
            << QByteArray(sceneOfSize(5, 5)).replace("\"pixelplumb\": 1", "\"pixelplumb\": 2")
            << "written by a newer Pixelplumb (format 2)";
    }
    void refusesScenesThatNoFrameCanHold()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QString, message);

        const ProgramRun result = run({"render", "-", "--ascii"}, scene);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(QString::fromUtf8(result.messages).contains(message), result.messages.constData());
    }

    void drawsFramesOfExtremeSizes_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("one pixel") << 1 << 1;
        QTest::newRow("one line") << 32768 << 1;
        QTest::newRow("one column") << 1 << 32768;
    }
    void drawsFramesOfExtremeSizes()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        const QString path = m_folder.filePath(QStringLiteral("extreme.png"));

        const ProgramRun picture = run({"render", "-", "-o", path}, sceneOfSize(width, height));
        const ProgramRun raster = run({"render", "-", "--ascii"}, sceneOfSize(width, height));

        QCOMPARE(picture.exitCode, 0);
        QCOMPARE(QImage(path).size(), QSize(width, height));
        QCOMPARE(raster.output.count('#'), qsizetype(width) * height);
        QCOMPARE(raster.output.count('\n'), qsizetype(height));
    }

    void rendersThePictureThatTheCoreDraws_data()
    {
        QTest::addColumn<QString>("suffix");
        QTest::newRow("PNG") << "png";
        QTest::newRow("BMP") << "bmp";
        QTest::newRow("PPM") << "ppm";
    }
    void rendersThePictureThatTheCoreDraws()
    {
        QFETCH(QString, suffix);
        const QString path = m_folder.filePath(QStringLiteral("picture.") + suffix);
        const Scene scene = readSceneFile(defaultScene())->scene;
        const FrameBuffer frame(scene.frame);
        drawScene(scene, frame);

        const ProgramRun result = run({"render", defaultScene(), "-o", path});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.output, QByteArray());
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32), frame.copy());
    }

    void writesThePictureToStandardOutput()
    {
        const ProgramRun result = run({"render", defaultScene(), "-o", "-"});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QImage::fromData(result.output, "PNG").size(), QSize(64, 48));
    }

    void printsTheRasterOfASceneOnStandardInput()
    {
        const ProgramRun result
            = run({"render", "-", "--ascii"},
                  QByteArray("{ \"pixelplumb\": 1, \"frame\": { \"width\": 6, \"height\": 5 }, "
                             "\"primitives\": [ { \"triangle\": [[1, 1], [4, 1], [1, 3]], "
                             "\"colors\": [\"#000000\", \"#000000\", \"#000000\"] } ] }"));

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.output, QByteArray("......\n.#....\n.##...\n.####.\n......\n"));
    }

    void obeysTheOptionsInsteadOfTheScene()
    {
        const ProgramRun closed = run({"render", defaultScene(), "--ascii"});
        const ProgramRun halfOpen
            = run({"render", defaultScene(), "--ascii", "--fill-rule", "half-open-column"});
        const ProgramRun float32
            = run({"trace", defaultScene(), "--format", "json", "--arithmetic", "float32",
                   "--rounding", "truncate", "--method", "column-scan"});

        QVERIFY(halfOpen.output.count('#') < closed.output.count('#'));
        const QJsonDocument document = QJsonDocument::fromJson(float32.output);
        QCOMPARE(document[QStringLiteral("arithmetic")].toString(), QStringLiteral("float32"));
        QCOMPARE(document[QStringLiteral("rounding")].toString(), QStringLiteral("truncate"));
    }

    void reportsSnappedVerticesAndDrawsThem()
    {
        const ProgramRun result = run({"render", "-", "--ascii"},
                                      QByteArray(sceneOfSize(5, 5)).replace("90000, 0", "12.1, 0"));

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QString::fromUtf8(result.messages),
                 QStringLiteral(
                     "-: primitives[0].triangle[1][0]: 12.1 is drawn at 1549/128, displaced by "
                     "1/640 px\n"));
    }

    void reportsDepthsThatTheBitsClamp()
    {
        const QByteArray scene = R"({ "pixelplumb": 1, "frame": { "width": 9, "height": 9 },
            "depthBits": 16, "primitives": [
            { "triangle": [[0, 0], [8, 0], [0, 8]], "z": [2, 0.5, -1],
              "colors": ["#ff0000", "#ff0000", "#ff0000"] } ] })";

        const ProgramRun clamped = run({"render", "-", "--ascii"}, scene);
        const ProgramRun exact
            = run({"render", "-", "--ascii"}, QByteArray(scene).replace("16,", "\"exact\","));

        QCOMPARE(clamped.exitCode, 0);
        QCOMPARE(QString::fromUtf8(clamped.messages),
                 QStringLiteral("-: 2 vertices have a depth outside 0 … 1, which 16 bits keep as 0 "
                                "or 1\n"));
        QCOMPARE(exact.messages, QByteArray());
    }

    void reportsManySnappedVerticesInFewLines()
    {
        QByteArray scene = sceneOfSize(5, 5);
        scene.replace("[-5, -5], [90000, 0], [0, 90000]", "[0.1, 0.1], [5.1, 0.1], [0.1, 5.1]");

        const ProgramRun result = run({"render", "-", "--ascii"}, scene);

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.messages.count('\n'), qsizetype(6));
        QVERIFY2(result.messages.contains("1 more coordinates are off the lattice"),
                 result.messages.constData());
    }

    void aScaledPictureHasASquareForEachPixel()
    {
        const QString plain = m_folder.filePath(QStringLiteral("plain.png"));
        const QString scaled = m_folder.filePath(QStringLiteral("scaled.png"));

        QCOMPARE(run({"render", defaultScene(), "-o", plain}).exitCode, 0);
        QCOMPARE(run({"render", defaultScene(), "-o", scaled, "--scale", "3"}).exitCode, 0);

        const QImage small(plain);
        const QImage large(scaled);
        QCOMPARE(large.size(), small.size() * 3);
        for (int y = 0; y < large.height(); ++y) {
            for (int x = 0; x < large.width(); ++x)
                QCOMPARE(large.pixel(x, y), small.pixel(x / 3, y / 3));
        }
    }

    void drawsTheFrameAsItIsAtAPosition()
    {
        const QString path = m_folder.filePath(QStringLiteral("moment.png"));
        const Scene scene = readSceneFile(defaultScene())->scene;
        const auto traced = traceScene(scene);
        TraceCursor cursor(*traced->trace, scene.frame);
        cursor.seek(traced->trace->stepCount() / 2);

        const ProgramRun result = run({"render", defaultScene(), "-o", path, "--position",
                                       QString::number(traced->trace->stepCount() / 2)});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32), cursor.frame().copy());
    }

    void layersLieOverThePicture()
    {
        const QString path = m_folder.filePath(QStringLiteral("layers.png"));
        const QString plainPath = m_folder.filePath(QStringLiteral("without.png"));

        const ProgramRun result
            = run({"render", defaultScene(), "-o", path, "--scale", "16", "--layers",
                   "box,half-planes", "--method", "edge-equations"});
        const ProgramRun plain = run({"render", defaultScene(), "-o", plainPath, "--scale", "16",
                                      "--method", "edge-equations"});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.messages, QByteArray());
        QCOMPARE(plain.exitCode, 0);
        const QImage picture(path);
        const QImage without(plainPath);
        QCOMPARE(picture.size(), QSize(64 * 16, 48 * 16));
        // The background is tinted where an edge function is positive, here E₀ and E₁.
        QVERIFY(picture.pixel(24, 20 * 16) != without.pixel(24, 20 * 16));
        // The box that was visited begins between the columns 3 and 4.
        QVERIFY(picture.pixel(4 * 16, 20 * 16) != picture.pixel(2 * 16, 20 * 16));
    }

    void layersSayWhatIsNotInThePicture()
    {
        const QString path = m_folder.filePath(QStringLiteral("said.png"));

        const ProgramRun result
            = run({"render", defaultScene(), "-o", path, "--layers", "weights,edge-table"});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QString::fromUtf8(result.messages),
                 QStringLiteral("--layers edge-table: “Column scan” has no such numbers, unlike "
                                "“Polygon by parity”, “Bézier path: filled”, “Text as "
                                "outlines”\nZoom in to read the numbers: a cell needs "
                                "24 pixels\n"));
    }

    void theAffineMapIsTheOneThatIsAskedFor()
    {
        const QString path = m_folder.filePath(QStringLiteral("affine.png"));

        // The default scene's triangle, moved by (1, 2).
        const ProgramRun result = run({"render", defaultScene(), "-o", path, "--layers",
                                       "affine-map", "--affine-image", "5,7 59,14 27.5,46"});

        QCOMPARE(result.exitCode, 0);
        QVERIFY2(QString::fromUtf8(result.messages)
                     .contains(QStringLiteral("x′ = 1·x + 0·y + 1\nand y′ = 0·x + 1·y + 2\n")),
                 result.messages.constData());
    }

    void theAffineMapTellsByHowMuchItsCornersAreDisplaced()
    {
        const ProgramRun result
            = run({"render", defaultScene(), "-o", m_folder.filePath(QStringLiteral("snapped.png")),
                   "--layers", "affine-map", "--affine-image", "5,7 12.1,14 53/2,46.3"});

        QCOMPARE(result.exitCode, 0);
        const QString messages = QString::fromUtf8(result.messages);
        QVERIFY2(messages.startsWith(QStringLiteral(
                     "--affine-image, point 2, x: 12.1 is drawn at 1549/128, displaced "
                     "by 1/640 px\n--affine-image, point 3, y: 46.3 is drawn at ")),
                 result.messages.constData());
        QCOMPARE(messages.count(QStringLiteral("displaced")), qsizetype(2));
    }

    void refusesLayersAndPositionsThatAreNotThere_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("message");
        QTest::newRow("unknown layer")
            << QStringList{"-o", "never.png", "--layers", "bx"} << "--layers: unknown layer “bx”";
        QTest::newRow("beyond the last step")
            << QStringList{"-o", "never.png", "--position", "99999"}
            << "--position: 99999; expected an integer from 0 to ";
        QTest::newRow("no such primitive")
            << QStringList{"-o", "never.png", "--layers", "box", "--triangle", "1"}
            << "--triangle: 1 is no primitive of the scene; expected 0 … 0";
        QTest::newRow("a primitive of no layer")
            << QStringList{"-o", "never.png", "--triangle", "0"} << "expected --layers";
        QTest::newRow("an image of no layer")
            << QStringList{"-o", "never.png", "--layers", "box", "--affine-image", "0,0 1,0 0,1"}
            << "expected --layers affine-map";
        QTest::newRow("two corners of three")
            << QStringList{"-o", "never.png", "--layers", "affine-map", "--affine-image", "0,0 1,0"}
            << "--affine-image: 0,0 1,0; expected three points such as “40,12 10,8 30,40”";
        QTest::newRow("no picture") << QStringList{"--ascii", "--layers", "box"}
                                    << "--layers and --position need a picture";
    }
    void refusesLayersAndPositionsThatAreNotThere()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, message);
        options.replaceInStrings(QStringLiteral("never.png"),
                                 m_folder.filePath(QStringLiteral("never.png")));

        const ProgramRun result = run(QStringList{"render", defaultScene()} + options);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(QString::fromUtf8(result.messages).contains(message), result.messages.constData());
        QVERIFY(!QFile::exists(m_folder.filePath(QStringLiteral("never.png"))));
    }

    void refusesScalesThatNoPictureHolds()
    {
        const QString path = m_folder.filePath(QStringLiteral("never.png"));

        const ProgramRun zero = run({"render", defaultScene(), "-o", path, "--scale", "0"});
        const ProgramRun large
            = run({"render", "-", "-o", path, "--scale", "64"}, sceneOfSize(9000, 9000));

        QCOMPARE(zero.exitCode, 2);
        QVERIFY2(zero.messages.contains("--scale: 0 is out of range; expected 1 … 64"),
                 zero.messages.constData());
        QCOMPARE(large.exitCode, 2);
        QVERIFY2(large.messages.contains("expected at most 268435456 pixels"),
                 large.messages.constData());
        QVERIFY(!QFile::exists(path));

        // There is nothing to enlarge.
        const ProgramRun raster = run({"render", defaultScene(), "--ascii", "--scale", "2"});
        QCOMPARE(raster.exitCode, 2);
        QVERIFY2(raster.messages.contains("--scale needs a picture; expected -o FILE"),
                 raster.messages.constData());
        QCOMPARE(raster.output, QByteArray());
    }

    void neverWritesOverItsInput_data()
    {
        QTest::addColumn<QStringList>("arguments"); // %1 the input, %2 the output
        QTest::addColumn<QString>("target");
        const auto rows = [](const char *command, const QStringList &arguments) {
            for (const char *target : {"scene.json", "./scene.json", "symlink.png", "hardlink.png"})
                QTest::addRow("%s, %s", command, target)
                    << arguments << QString::fromLatin1(target);
        };
        rows("trace", {"trace", "%1", "-o", "%2"});
        rows("trace of standard input", {"trace", "-", "-o", "%2"});
        rows("trace by pixels", {"trace", "%1", "--level", "pixel", "-o", "%2"});
        rows("render", {"render", "%1", "-o", "%2"});
    }
    void neverWritesOverItsInput()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, target);
        const QTemporaryDir folder;
        const QString scene = folder.filePath(QStringLiteral("scene.json"));
        QVERIFY(QFile::copy(defaultScene(), scene));
        QVERIFY(QFile::link(scene, folder.filePath(QStringLiteral("symlink.png"))));
        QVERIFY(
            ::link(QFile::encodeName(scene).constData(),
                   QFile::encodeName(folder.filePath(QStringLiteral("hardlink.png"))).constData())
            == 0);
        const QByteArray before = *readFile(scene);
        arguments.replaceInStrings(QStringLiteral("%1"), scene)
            .replaceInStrings(QStringLiteral("%2"), folder.path() + u'/' + target);

        QProcess process;
        process.setStandardInputFile(scene);
        process.start(program(), arguments);
        QVERIFY(process.waitForFinished());

        QCOMPARE(process.exitCode(), 2);
        const QByteArray messages = process.readAllStandardError();
        // A picture cannot be called .json.
        QVERIFY2(messages.contains("is the input, which it would replace")
                     || messages.contains("unknown kind of picture"),
                 messages.constData());
        QCOMPARE(*readFile(scene), before);
    }

    void namesTheReasonWhenTheDiskIsFull_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char *ending : {"png", "bmp", "ppm"})
            QTest::newRow(ending) << QString::fromLatin1(ending);
    }
    void namesTheReasonWhenTheDiskIsFull()
    {
        QFETCH(QString, ending);
        const QString path = m_folder.filePath(QStringLiteral("full.") + ending);
        QVERIFY(QFile::link(QStringLiteral("/dev/full"), path));

        for (const char *scale : {"1", "30"}) { // more than a buffer holds, too
            const ProgramRun result = run(
                {"render", defaultScene(), "--scale", QString::fromLatin1(scale), "-o", path});

            QCOMPARE(result.exitCode, 2);
            QCOMPARE(QString::fromUtf8(result.messages),
                     QStringLiteral("pixelplumb-cli render: %1: cannot be written: No space left "
                                    "on device\n")
                         .arg(path));
        }
    }

private:
    QTemporaryDir m_folder;
};

PIXELPLUMB_TEST(TestRenderCommand)

} // namespace tst_rendercommand

#include "tst_rendercommand.moc"
