// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/scene/fileaccess.h"
#include "core/scene/scenefile.h"
#include "core/trace/tracedscene.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace pixelplumb;

namespace {

const QString defaultScene = QStringLiteral(PIXELPLUMB_RESOURCES "/scenes/default.json");

/// How a run of the program ended and what it said.
struct Run {
    int exitCode = -1;
    QByteArray output;
    QByteArray messages;
};

Run run(const QStringList &arguments, const QByteArray &input = {})
{
    QProcess process;
    process.start(QStringLiteral(PIXELPLUMB_CLI), arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(120'000) || process.exitStatus() != QProcess::NormalExit)
        return {-1, {}, "did not end by itself"};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

QByteArray sceneOfSize(int width, int height)
{
    return "{ \"pixelplumb\": 1, \"frame\": { \"width\": " + QByteArray::number(width)
        + ", \"height\": " + QByteArray::number(height) + " }, \"primitives\": [ { \"triangle\": "
        + "[[-5, -5], [90000, 0], [0, 90000]], \"colors\": [\"#ff0000\", \"#00ff00\", \"#0000ff\"] "
          "} ] }";
}

} // namespace

class tst_CommandLine : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void saysWhatItCanDo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("beginning");
        QTest::addColumn<QString>("within");
        QTest::newRow("help") << QStringList{"--help"} << "Usage: pixelplumb-cli COMMAND"
                              << "check ";
        QTest::newRow("h") << QStringList{"-h"} << "Usage: pixelplumb-cli COMMAND"
                           << "render ";
        QTest::newRow("render") << QStringList{"render", "--help"}
                                << "Usage: pixelplumb-cli render [options] SCENE\n"
                                << "--ascii";
        QTest::newRow("trace") << QStringList{"trace", "--help"}
                               << "Usage: pixelplumb-cli trace [options] SCENE\n"
                               << "--level";
        QTest::newRow("pixel") << QStringList{"pixel", "-h"}
                               << "Usage: pixelplumb-cli pixel [options] SCENE X Y\n"
                               << "--json";
        QTest::newRow("methods") << QStringList{"methods", "--help"}
                                 << "Usage: pixelplumb-cli methods [options]\n"
                                 << "--json";
        QTest::newRow("check") << QStringList{"check", "--help"}
                               << "Usage: pixelplumb-cli check [options] CASES\n"
                               << "--arithmetic";
        QTest::newRow("version") << QStringList{"--version"} << "pixelplumb-cli "
                                 << "0";
    }
    void saysWhatItCanDo()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, beginning);
        QFETCH(QString, within);

        const Run result = run(arguments);

        QCOMPARE(result.exitCode, 0);
        const QString output = QString::fromUtf8(result.output);
        QVERIFY2(output.startsWith(beginning) && output.contains(within),
                 result.output.constData());
        QCOMPARE(result.messages, QByteArray());
    }

    void refusesAWrongCommandLineWithAHint_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QStringList &arguments, const char *message) {
            QTest::newRow(name) << arguments << QString::fromUtf8(message);
        };
        row("nothing", {}, "pixelplumb-cli: a command is missing");
        row("typing error", {"rendre", defaultScene},
            "unknown command “rendre”; did you mean render?");
        row("no command at all", {"xyzzy"}, "unknown command “xyzzy”\n");
        row("option for a command", {"--versoin"},
            "unknown option --versoin; did you mean --version?");
        row("unknown option", {"render", defaultScene, "--asci"},
            "pixelplumb-cli render: unknown option --asci; did you mean --ascii?");
        row("unknown short option", {"render", defaultScene, "-x"}, "unknown option -x");
        row("no scene", {"render", "--ascii"}, "SCENE is missing");
        row("one too many", {"render", defaultScene, "again", "--ascii"},
            "unexpected argument “again”");
        row("methods takes none", {"methods", "all"}, "unexpected argument “all”");
        row("value missing", {"render", defaultScene, "-o"}, "Missing value after '-o'");
        row("nothing to do", {"render", defaultScene},
            "nothing to do; expected -o FILE, --ascii or both");
        row("two results on stdout", {"render", defaultScene, "--ascii", "-o", "-"},
            "-o - and --ascii both need standard output");
        row("unknown picture", {"render", defaultScene, "-o", "out.jpeg2"},
            "unknown kind of picture; expected a name that ends in .png, .bmp, .ppm");
        row("method", {"render", defaultScene, "--ascii", "--method", "colum-scan"},
            "--method: unknown name “colum-scan”; did you mean column-scan?");
        row("arithmetic", {"trace", defaultScene, "--arithmetic", "float"},
            "--arithmetic: unknown name “float”; did you mean float32?; expected one of exact, "
            "float32, "
            "float64, fixed16.16, fixed32.32");
        row("fill rule", {"trace", defaultScene, "--fill-rule", "half-open"},
            "--fill-rule: unknown name “half-open”");
        row("rule that the method does not keep",
            {"trace", defaultScene, "--fill-rule", "top-left"},
            "cannot keep the fill rule “top-left”: a column ends at its two bounds whatever edge "
            "they "
            "belong to; it keeps closed, half-open-column");
        row("rounding", {"trace", defaultScene, "--rounding", "down"},
            "expected one of nearest, truncate");
        row("level", {"trace", defaultScene, "--level", "row"}, "expected column or pixel");
        row("format", {"trace", defaultScene, "--format", "cvs"},
            "did you mean csv?; expected csv or json");
        row("no row", {"pixel", defaultScene, "3"}, "Y is missing: the pixel's row");
        row("x is no number", {"pixel", defaultScene, "three", "4"},
            "X: “three” is no whole number; expected 0 … 63");
        row("x outside", {"pixel", defaultScene, "64", "4"},
            "X: 64 is outside the frame; expected 0 … 63");
        row("y outside", {"pixel", defaultScene, "4", "-1"},
            "Y: -1 is outside the frame; expected 0 … 47");
        row("nan", {"pixel", defaultScene, "nan", "4"}, "X: “nan” is no whole number");
        row("beyond 64 bits", {"pixel", defaultScene, "99999999999999999999", "4"},
            "is no whole number");
        row("check arithmetic", {"check", "cases.json", "--arithmetic", "exat"},
            "did you mean exact?");
        row("check rule without method",
            {"check", "cases.json", "--method", "column-scan", "--fill-rule", "off-screen-point"},
            "no method draws in this arithmetic under this rule");
    }
    void refusesAWrongCommandLineWithAHint()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, message);

        const Run result = run(arguments);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(QString::fromUtf8(result.messages).contains(message), result.messages.constData());
        QCOMPARE(result.output, QByteArray());
    }

    void everyCommandRefusesInputThatCannotBeRead_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QString>("message");
        const QByteArray whole = *readFile(defaultScene);
        const std::pair<const char *, QStringList> commandLines[]
            = {{"render", {"render", "-", "--ascii"}},
               {"trace", {"trace", "-"}},
               {"pixel", {"pixel", "-", "1", "1"}},
               {"check", {"check", "-"}}};
        const std::tuple<const char *, QByteArray, const char *> inputs[]
            = {{"nothing", "", "-, the input is empty; expected JSON"},
               {"cut short", whole.first(whole.size() / 2), "-, line "},
               {"binary", QByteArray(300, '\xff'), "-, line 1, column 2: "},
               {"a number", "7", "-, line 1"},
               {"wrong types", "{\"pixelplumb\": [], \"version\": {}, \"cases\": 3}",
                "-, line 1, column "},
               {"newer", "{\"pixelplumb\": 7, \"version\": 7}", "-, line 1, column "}};
        for (const auto &commandLine : commandLines) {
            for (const auto &[name, input, message] : inputs)
                QTest::addRow("%s, %s", commandLine.first, name)
                    << commandLine.second << input << QString::fromUtf8(message);
        }
    }
    void everyCommandRefusesInputThatCannotBeRead()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, input);
        QFETCH(QString, message);

        const Run result = run(arguments, input);

        QCOMPARE(result.exitCode, 2);
        const QString messages = QString::fromUtf8(result.messages)
                                     .replace(QStringLiteral("-: "), QStringLiteral("-, "));
        QVERIFY2(messages.contains(message), result.messages.constData());
        QCOMPARE(result.output, QByteArray());
    }

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
                             << "3000000000 is outside ±1073741824 px";
        QTest::newRow("newer")
            << QByteArray(sceneOfSize(5, 5)).replace("\"pixelplumb\": 1", "\"pixelplumb\": 2")
            << "written by a newer Pixelplumb (format 2)";
    }
    void refusesScenesThatNoFrameCanHold()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QString, message);

        const Run result = run({"render", "-", "--ascii"}, scene);

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

        const Run picture = run({"render", "-", "-o", path}, sceneOfSize(width, height));
        const Run raster = run({"render", "-", "--ascii"}, sceneOfSize(width, height));

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
        const Scene scene = readSceneFile(defaultScene)->scene;
        const FrameBuffer frame(scene.frame);
        drawScene(scene, frame);

        const Run result = run({"render", defaultScene, "-o", path});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.output, QByteArray());
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32), frame.copy());
    }

    void writesThePictureToStandardOutput()
    {
        const Run result = run({"render", defaultScene, "-o", "-"});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QImage::fromData(result.output, "PNG").size(), QSize(64, 48));
    }

    void printsTheRasterOfASceneOnStandardInput()
    {
        const Run result
            = run({"render", "-", "--ascii"},
                  QByteArray("{ \"pixelplumb\": 1, \"frame\": { \"width\": 6, \"height\": 5 }, "
                             "\"primitives\": [ { \"triangle\": [[1, 1], [4, 1], [1, 3]], "
                             "\"colors\": [\"#000000\", \"#000000\", \"#000000\"] } ] }"));

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.output, QByteArray("......\n.#....\n.##...\n.####.\n......\n"));
    }

    void obeysTheOptionsInsteadOfTheScene()
    {
        const Run closed = run({"render", defaultScene, "--ascii"});
        const Run halfOpen
            = run({"render", defaultScene, "--ascii", "--fill-rule", "half-open-column"});
        const Run float32 = run({"trace", defaultScene, "--format", "json", "--arithmetic",
                                 "float32", "--rounding", "truncate", "--method", "column-scan"});

        QVERIFY(halfOpen.output.count('#') < closed.output.count('#'));
        const QJsonDocument document = QJsonDocument::fromJson(float32.output);
        QCOMPARE(document[QStringLiteral("arithmetic")].toString(), QStringLiteral("float32"));
        QCOMPARE(document[QStringLiteral("rounding")].toString(), QStringLiteral("truncate"));
    }

    void reportsSnappedVerticesAndDrawsThem()
    {
        const Run result = run({"render", "-", "--ascii"},
                               QByteArray(sceneOfSize(5, 5)).replace("90000, 0", "12.1, 0"));

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QString::fromUtf8(result.messages),
                 QStringLiteral(
                     "-: primitives[0].triangle[1][0]: 12.1 is drawn at 1549/128, displaced by "
                     "1/640 px\n"));
    }

    void reportsManySnappedVerticesInFewLines()
    {
        QByteArray scene = sceneOfSize(5, 5);
        scene.replace("[-5, -5], [90000, 0], [0, 90000]", "[0.1, 0.1], [5.1, 0.1], [0.1, 5.1]");

        const Run result = run({"render", "-", "--ascii"}, scene);

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.messages.count('\n'), qsizetype(6));
        QVERIFY2(result.messages.contains("1 more coordinates are off the lattice"),
                 result.messages.constData());
    }

    void tracesToStandardOutputAndToAFileAlike()
    {
        const QString path = m_folder.filePath(QStringLiteral("trace.csv"));

        const Run printed = run({"trace", defaultScene, "--level", "pixel"});
        const Run written = run({"trace", defaultScene, "--level", "pixel", "-o", path});

        QCOMPARE(printed.exitCode, 0);
        QCOMPARE(written.exitCode, 0);
        QVERIFY(printed.output.startsWith("step,primitive,x,y,R,"));
        QCOMPARE(*readFile(path), printed.output);
        QCOMPARE(written.output, QByteArray());
    }

    void leavesNoFileBehindThatCannotBeFinished()
    {
        const QString path = m_folder.filePath(QStringLiteral("none/trace.csv"));

        const Run result = run({"trace", defaultScene, "-o", path});

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("cannot be written"), result.messages.constData());
    }

    void saysThatStandardOutputIsFull()
    {
        QProcess process;
        process.setStandardOutputFile(QStringLiteral("/dev/full"));
        process.start(QStringLiteral(PIXELPLUMB_CLI), {"render", defaultScene, "--ascii"});
        QVERIFY(process.waitForFinished());

        QCOMPARE(process.exitCode(), 2);
        QVERIFY(process.readAllStandardError().contains("standard output cannot be written"));
    }

    void tellsWhoWroteAPixel()
    {
        const Run result = run({"pixel", defaultScene, "27", "19"});

        QCOMPARE(result.exitCode, 0);
        QVERIFY2(
            result.output.startsWith("pixel (27, 19) #654c4e, as the truth\ntriangle 0, step "),
            result.output.constData());
        QVERIFY(
            QString::fromUtf8(result.output).contains(QStringLiteral("R = 100 1255/1299 → 101")));
    }

    void tellsWhichEdgeRefusesAPixel()
    {
        const Run result = run({"pixel", defaultScene, "0", "0", "--json"});

        QCOMPARE(result.exitCode, 0);
        const QJsonDocument document = QJsonDocument::fromJson(result.output);
        const QJsonValue attempt = document[QStringLiteral("attempts")][0];
        QCOMPARE(document[QStringLiteral("colour")].toString(), QStringLiteral("#000000"));
        QCOMPARE(attempt[QStringLiteral("written")].toBool(true), false);
        QCOMPARE(attempt[QStringLiteral("edges")].toArray().size(), qsizetype(3));
        QCOMPARE(attempt[QStringLiteral("edges")][0][QStringLiteral("accepts")].toBool(true),
                 false);
        QCOMPARE(attempt[QStringLiteral("edges")][0][QStringLiteral("alongColumn")].toString(),
                 QStringLiteral("-4 13/27"));
    }

    void takesNegativeCoordinates()
    {
        const QByteArray scene
            = QByteArray(sceneOfSize(8, 8))
                  .replace("\"height\": 8", "\"height\": 8, \"firstPixel\": [-4, -4]");

        const Run result = run({"pixel", "-", "-3", "-2", "--json"}, scene);

        QCOMPARE(result.exitCode, 0);
        const QJsonDocument document = QJsonDocument::fromJson(result.output);
        QCOMPARE(document[QStringLiteral("x")].toInt(), -3);
        QCOMPARE(document[QStringLiteral("y")].toInt(), -2);
        QVERIFY(document[QStringLiteral("attempts")][0][QStringLiteral("written")].toBool());
    }

    void listsTheMethods()
    {
        const Run text = run({"methods"});
        const Run json = run({"methods", "--json"});

        QCOMPARE(text.exitCode, 0);
        QVERIFY(text.output.startsWith("column-scan: Column scan\n"));
        const QJsonArray list = QJsonDocument::fromJson(json.output).array();
        QCOMPARE(std::size_t(list.size()), methods().size());
        QCOMPARE(list[0][QStringLiteral("id")].toString(), QStringLiteral("column-scan"));
        QVERIFY(list[0][QStringLiteral("arithmetics")].toArray().contains(
            QStringLiteral("fixed16.16")));
        QVERIFY(list[0][QStringLiteral("fillRules")].toArray().contains(
            QStringLiteral("half-open-column")));
    }

    void checksAllHardCases()
    {
        const Run result = run({"check", QFINDTESTDATA("data/hard_cases.json")});

        QCOMPARE(result.exitCode, 0);
        const QList<QByteArray> lines = result.output.trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(83));
        QCOMPARE(lines.front(), QByteArray("pass  sliver_unimodular_1999  43 of 43"));
        QCOMPARE(lines.back(), QByteArray("82 cases: 82 passed, 0 fell short, 0 skipped"));
    }

    void endsWithOneWhenACaseFallsShort()
    {
        const QString cases = QFINDTESTDATA("data/hard_cases.json");

        const QStringList arguments = {"check",        cases,     "--method",    "column-scan",
                                       "--arithmetic", "float32", "--fill-rule", "closed"};

        const Run text = run(arguments);
        const Run json = run(arguments + QStringList{"--json"});

        QCOMPARE(text.exitCode, 1);
        QVERIFY2(text.output.contains(
                     "FAIL  tie_tenths  0 of 1\n      column-scan float32 closed: 64 pixels "
                     "missing"),
                 text.output.constData());
        QCOMPARE(json.exitCode, 1);
        const QJsonDocument document = QJsonDocument::fromJson(json.output);
        QVERIFY(document[QStringLiteral("fellShort")].toInt() > 0);
        QCOMPARE(document[QStringLiteral("cases")].toArray().size(), qsizetype(82));
    }

    void checksEveryArithmeticWhenAsked()
    {
        const QByteArray oneCase
            = "{\"version\": 1, \"cases\": [{\"id\": \"small\", \"kind\": \"triangle\", \"scale\": "
              "1, "
              "\"vertices\": [[0, 0], [4, 0], [0, 4]], \"canvas\": [6, 6], \"origin\": [0, 0], "
              "\"expected\": {\"closed\": {\"count\": 15}}}]}";

        const Run result
            = run({"check", "-", "--method", "column-scan", "--arithmetic", "all"}, oneCase);

        QCOMPARE(result.exitCode, 0);
        // Five arithmetics under closed; the case says nothing about half-open-column.
        QCOMPARE(result.output,
                 QByteArray("pass  small  5 of 5\n1 cases: 1 passed, 0 fell short, 0 skipped\n"));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(tst_CommandLine)
#include "tst_commandline.moc"
