// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/fileaccess.h"
#include "core/scene/scenefile.h"

#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QtTest>

using namespace pixelplumb;

namespace {

QByteArray sceneWith(const QByteArray &members)
{
    return "{\n  \"pixelplumb\": 1,\n  \"frame\": { \"width\": 64, \"height\": 48 },\n" + members
        + "\n}\n";
}

QByteArray triangleAt(const QByteArray &firstX)
{
    return sceneWith(
        "  \"primitives\": [\n    { \"triangle\": [[" + firstX
        + ", 5], [58, 12], [26, 44]], \"colors\": [\"#ff0000\", \"#00ff00\", \"#0000ff\"] }\n  ]");
}

QByteArray frameOf(const QByteArray &frame)
{
    return "{ \"pixelplumb\": 1, \"frame\": " + frame + ", \"primitives\": [] }";
}

QString errorOf(const QByteArray &text)
{
    const Result<SceneReading> reading = readScene(text);
    return reading ? QStringLiteral("no error") : reading.error().message();
}

Scene randomScene(quint32 seed)
{
    QRandomGenerator random(seed);
    const auto chosen = [&](const auto &choices) {
        return choices[std::size_t(random.bounded(int(choices.size())))];
    };
    const auto coordinate = [&] {
        const qint64 largest = random.bounded(2) == 0 ? 64 * unitsPerPixel : largestCoordinate;
        return Lattice(random.bounded(qint64(-largest), qint64(largest + 1)));
    };
    const auto colour = [&] {
        return Colour{{std::uint8_t(random.bounded(256)), std::uint8_t(random.bounded(256)),
                       std::uint8_t(random.bounded(256))}};
    };
    Scene scene;
    scene.frame.width = random.bounded(1, largestFrameSide + 1);
    scene.frame.height = random.bounded(1, 100);
    scene.frame.background = colour();
    scene.frame.origin = random.bounded(2) == 0 ? FrameOrigin::BottomLeft : FrameOrigin::TopLeft;
    scene.frame.pixelCentre = random.bounded(2) == 0 ? PixelCentre::Integer : PixelCentre::Half;
    const auto firstPixel = [&] {
        return std::int32_t(random.bounded(qint64(-largestPixel), qint64(largestPixel + 1)));
    };
    scene.frame.firstColumn = random.bounded(2) == 0 ? 0 : firstPixel();
    scene.frame.firstRow = random.bounded(2) == 0 ? 0 : firstPixel();
    scene.settings.arithmetic = chosen(allArithmetics);
    scene.settings.fillRule = random.bounded(2) == 0 ? FillRule::Closed : FillRule::HalfOpenColumn;
    scene.settings.rounding = chosen(allByteRoundings);
    scene.triangles.resize(std::size_t(random.bounded(5)));
    for (Triangle &triangle : scene.triangles) {
        for (Vertex &vertex : triangle.vertices)
            vertex = {{coordinate(), coordinate()}, colour()};
    }
    return scene;
}

} // namespace

class tst_SceneFile : public QObject {
    Q_OBJECT

private slots:
    void readsACoordinateExactly_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<qint64>("units");
        QTest::addColumn<QString>("displacement");
        const auto row = [](const char *text, qint64 units, const char *displacement = "0") {
            QTest::newRow(text) << QString::fromUtf8(text) << units
                                << QString::fromUtf8(displacement);
        };
        row("26", 26 * 256);
        row("-26", -26 * 256);
        row("+26", 26 * 256);
        row("−26", -26 * 256);
        row(" 26 ", 26 * 256);
        row("26.5", 26 * 256 + 128);
        row("26.", 26 * 256);
        row(".5", 128);
        row("1e3", 1000 * 256);
        row("2.65E+1", 26 * 256 + 128);
        row("256e-2", 655, "-9/6400"); // 2.56 px = 655.36 units
        row("27/2", 13 * 256 + 128);
        row("17 3/8", 17 * 256 + 96);
        row("17\u20093/8", 17 * 256 + 96);
        row("-17 3/8", -(17 * 256 + 96));
        row("1/3", 85, "-1/768"); // 256/3 = 85 1/3
        row("-1/3", -85, "1/768");
        row("12.1", 3098, "1/640"); // 3097.6 units
        row("1/512", 1, "1/512"); // halves go up
        row("-1/512", 0, "1/512");
        row("3/512", 2, "1/512");
        row("-3/512", -1, "1/512");
        row("-0", 0);
        row("1073741824", largestCoordinate);
        row("-1073741824", -largestCoordinate);
        // 0.1 is no double, and the lattice is not 0.1: 25.6 units.
        row("0.1", 26, "1/640");
        // One part in 10^30 above the middle between two lattice points decides.
        row("0.001953124999999999999999999999999999", 0, "-0.001953125");
        row("0.001953125000000000000000000000000001", 1, "0.001953125");
        row("4181389724724491839037947176121567782371328/"
            "1393796574908163946345982392040522594123776",
            3 * 256);
        row("1/1393796574908163946345982392040522594123776", 0, "-7.174648137343064e-43");
        row("1e-999", 0, "-5e-324");
    }
    void readsACoordinateExactly()
    {
        QFETCH(QString, text);
        QFETCH(qint64, units);
        QFETCH(QString, displacement);

        const Result<SnappedCoordinate> snapped = parseCoordinate(text);

        QVERIFY2(snapped.isOk(), snapped ? "" : qPrintable(snapped.error().message()));
        QCOMPARE(snapped->units, units);
        QCOMPARE(toText(snapped->displacement), displacement);
        QCOMPARE(snapped->isDisplaced(), displacement != QStringLiteral("0"));
    }

    void refusesWhatIsNoCoordinate_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("found");
        const auto row = [](const char *text, const char *found) {
            QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(found);
        };
        row("", "“” is no coordinate");
        row("nan", "“nan” is no coordinate");
        row("NaN", "“NaN” is no coordinate");
        row("inf", "“inf” is no coordinate");
        row("-Infinity", "“-Infinity” is no coordinate");
        row("twelve", "“twelve” is no coordinate");
        row("1.2.3", "“1.2.3” is no coordinate");
        row("1,5", "“1,5” is no coordinate");
        row("--1", "“--1” is no coordinate");
        row("0x10", "“0x10” is no coordinate");
        row(".", "“.” is no coordinate");
        row("e5", "“e5” is no coordinate");
        row("1e", "“1e” is no coordinate");
        row("1/2/3", "“1/2/3” is no coordinate");
        row("1/-2", "“1/-2” is no coordinate");
        row("1.5 1/2", "“1.5 1/2” is no coordinate");
        row("1 2", "“1 2” is no coordinate");
        row("٣", "“٣” is no coordinate");
        row("1/0", "1/0 divides by zero");
        row("3e9", "3e9 is outside ±1073741824 px");
        row("-1073741825", "-1073741825 is outside ±1073741824 px");
        row("1073741824.0000000000000000000001",
            "1073741824.0000000000000000000001 is outside ±1073741824 px");
        row("1e99999999999999999999", "1e99999999999999999999 is outside ±1073741824 px");
    }
    void refusesWhatIsNoCoordinate()
    {
        QFETCH(QString, text);
        QFETCH(QString, found);

        const Result<SnappedCoordinate> snapped = parseCoordinate(text);

        QVERIFY(!snapped.isOk());
        QCOMPARE(snapped.error().found, found);
    }

    void refusesATextOfAThousandDigits()
    {
        const Result<SnappedCoordinate> snapped = parseCoordinate(QString(1000, u'1'));

        QVERIFY(!snapped.isOk());
        QVERIFY(snapped.error().found.endsWith(QStringLiteral("is longer than 400 characters")));
    }

    void writesTheShortestExactCoordinate_data()
    {
        QTest::addColumn<qint64>("units");
        QTest::addColumn<QString>("text");
        QTest::newRow("whole") << qint64(26 * 256) << "26";
        QTest::newRow("half") << qint64(26 * 256 + 128) << "53/2";
        QTest::newRow("negative") << qint64(-1) << "-1/256";
        QTest::newRow("zero") << qint64(0) << "0";
        QTest::newRow("largest") << qint64(largestCoordinate - 1) << "274877906943/256";
    }
    void writesTheShortestExactCoordinate()
    {
        QFETCH(qint64, units);
        QFETCH(QString, text);

        QCOMPARE(coordinateText(units), text);
        QCOMPARE(parseCoordinate(text)->units, units);
    }

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
        const Result<SceneReading> reading = readScene(frameOf(R"({ "width": 3, "height": 2 })"));

        QVERIFY(reading.isOk());
        Scene expected;
        expected.frame.width = 3;
        expected.frame.height = 2;
        QCOMPARE(reading->scene, expected);
    }

    void reportsEachVertexThatWasSnapped()
    {
        const Result<SceneReading> reading = readScene(triangleAt("12.1"));

        QVERIFY(reading.isOk());
        QCOMPARE(reading->snaps.size(), std::size_t(1));
        QCOMPARE(
            reading->snaps.front().message(),
            QStringLiteral("primitives[0].triangle[0][0]: 12.1 is drawn at 1549/128, displaced by "
                           "1/640 px"));
    }

    void opensEveryTeachingScene_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder(QStringLiteral(PIXELPLUMB_RESOURCES "/scenes"));
        const QStringList names = folder.entryList({QStringLiteral("*.json")});
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
        QVERIFY(!reading->scene.triangles.empty() || !reading->scene.shapes.empty());
    }

    void namesTheFaultAndItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &text, const char *message) {
            QTest::newRow(name) << text << QString::fromUtf8(message);
        };
        const char *primitives = "\"primitives\": []";
        row("empty", "", "the input is empty; expected JSON");
        row("blank", " \n ", "the input is empty; expected JSON");
        row("an array", "[1]",
            "line 1, column 1, pixelplumb: no format number: this is no Pixelplumb scene; expected "
            "\"pixelplumb\": 1");
        row("some other object", "{\"a\": 1}",
            "line 1, column 1, pixelplumb: no format number: this is no Pixelplumb scene; expected "
            "\"pixelplumb\": 1");
        row("newer", "{\"new\": true,\n \"pixelplumb\": 2}",
            "line 2, column 16, pixelplumb: written by a newer Pixelplumb (format 2); expected a "
            "format up "
            "to 1, the newest that this one reads");
        row("version zero", "{\"pixelplumb\": 0}",
            "line 1, column 16, pixelplumb: 0; expected an integer from 1 to 1");
        row("version as text", "{\"pixelplumb\": \"1\"}",
            "line 1, column 16, pixelplumb: “1”; expected an integer from 1 to 1");
        row("unknown key", sceneWith("  \"fillrule\": \"closed\", \"primitives\": []"),
            "line 4, column 15, fillrule: unknown key “fillrule”; expected one of pixelplumb, "
            "frame, method, "
            "arithmetic, fillRule, rounding, primitives");
        row("key twice", sceneWith("  \"primitives\": [],\n  \"primitives\": []"),
            "line 5, column 17, primitives: the key is there twice; expected every key once");
        row("key twice, deep", frameOf(R"({ "width": 1, "height": 2, "width": 3 })"),
            "line 1, column 65, frame.width: the key is there twice; expected every key once");
        row("no frame", QByteArray("{ \"pixelplumb\": 1, ") + primitives + "}",
            "line 1, column 1, frame: nothing; expected an object");
        row("no primitives", sceneWith("\"fillRule\": \"closed\""),
            "line 1, column 1, primitives: nothing; expected an array");
        row("width missing", frameOf(R"({ "height": 2 })"),
            "line 1, column 29, frame.width: nothing; expected an integer from 1 to 32768");
        row("width 0", frameOf(R"({ "width": 0, "height": 2 })"),
            "line 1, column 40, frame.width: 0; expected an integer from 1 to 32768");
        row("width too large", frameOf(R"({ "width": 32769, "height": 2 })"),
            "line 1, column 40, frame.width: 32769; expected an integer from 1 to 32768");
        row("width with a fraction", frameOf(R"({ "width": 2.5, "height": 2 })"),
            "line 1, column 40, frame.width: 2.5; expected an integer from 1 to 32768");
        row("width beyond 64 bits", frameOf(R"({ "width": 1e30, "height": 2 })"),
            "line 1, column 40, frame.width: 1000000000000000019884624838656; expected an integer "
            "from 1 to "
            "32768");
        row("area too large", frameOf(R"({ "width": 32768, "height": 32768 })"),
            "line 1, column 40, frame.width: 32768 × 32768 are 1073741824 pixels; expected at most "
            "268435456 "
            "pixels");
        row("first pixel too far",
            frameOf(R"({ "width": 1, "height": 1, "firstPixel": [0, 1073741825] })"),
            "line 1, column 74, frame.firstPixel[1]: 1073741825; expected an integer from "
            "-1073741824 to "
            "1073741824");
        row("origin", frameOf(R"({ "width": 1, "height": 1, "origin": "top-right" })"),
            "line 1, column 66, frame.origin: “top-right”; expected one of bottom-left, top-left");
        row("background", frameOf(R"({ "width": 1, "height": 1, "background": "black" })"),
            "line 1, column 70, frame.background: “black” is no colour; expected #rrggbb in "
            "hexadecimal "
            "digits");
        row("blending", frameOf("{ \"width\": 1, \"height\": 1, \"background\": \"#f0203080\" }"),
            "line 1, column 70, frame.background: “#f0203080” is not opaque, and blending is not "
            "available; "
            "expected alpha ff, or #rrggbb without alpha");
        row("rule that the method does not keep",
            sceneWith(R"("fillRule": "off-screen-point", "primitives": [])"),
            "line 4, column 13, fillRule: method “column-scan” cannot keep the fill rule "
            "“off-screen-point”: "
            "a column ends at its two bounds whatever edge they belong to; it keeps closed, "
            "half-open-column");
        row("coordinate too large", triangleAt("3e9"),
            "line 5, column 21, primitives[0].triangle[0][0]: 3000000000 is outside ±1073741824 "
            "px; expected "
            "a coordinate such as 26, 26.5 or 53/2 within ±1073741824 px");
        row("coordinate nan", triangleAt("\"nan\""),
            "line 5, column 21, primitives[0].triangle[0][0]: “nan” is no coordinate; expected a "
            "coordinate "
            "such as 26, 26.5 or 53/2 within ±1073741824 px");
        row("coordinate null", triangleAt("null"),
            "line 5, column 21, primitives[0].triangle[0][0]: null; expected a coordinate such as "
            "26, 26.5 "
            "or 53/2 within ±1073741824 px");
        row("two vertices",
            sceneWith(R"("primitives": [{ "triangle": [[0, 0], [1, 1]], "colors": [] }])"),
            "line 4, column 30, primitives[0].triangle: an array of 2; expected an array of 3");
        row("three coordinates",
            sceneWith(
                R"("primitives": [{ "triangle": [[0, 0, 0], [1, 1], [2, 0]], "colors": [0, 0, 0] }])"),
            "line 4, column 31, primitives[0].triangle[0]: an array of 3; expected an array of 2");
        row("no colours", sceneWith(R"("primitives": [{ "triangle": [[0, 0], [1, 1], [2, 0]] }])"),
            "line 4, column 16, primitives[0].colors: nothing; expected an array");
        row("after an umlaut", QByteArray("{\"ä\": 1,\"ä\": 2}"),
            "line 1, column 14, ä: the key is there twice; expected every key once");
    }
    void namesTheFaultAndItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);

        QCOMPARE(errorOf(text), message);
    }

    void namesAllMethodsWhereThereIsNoSuchOne()
    {
        QStringList ids;
        for (const Method &method : methods())
            ids.append(method.id);

        QCOMPARE(errorOf(sceneWith(R"("method": "raytracer", "primitives": [])")),
                 QStringLiteral("line 4, column 11, method: “raytracer”; expected one of ")
                     + ids.join(QStringLiteral(", ")));
    }

    void tellsLineAndColumnOfASyntaxError()
    {
        const Result<SceneReading> reading = readScene("{\n  \"pixelplumb\": 1,\n  oops\n}");

        QVERIFY(!reading.isOk());
        QVERIFY2(reading.error().place.startsWith(QStringLiteral("line 3, column ")),
                 qPrintable(reading.error().message()));
    }

    void refusesEveryTextThatIsCutShort()
    {
        const QByteArray text = writeScene(randomScene(4));
        const qsizetype meaningful = text.trimmed().size();
        for (qsizetype length = 0; length < meaningful; ++length)
            QVERIFY2(!readScene(text.first(length)).isOk(), qPrintable(QString::number(length)));
    }

    void survivesAnyByteThatIsWrong()
    {
        const QByteArray text = writeScene(randomScene(7));
        for (qsizetype position = 0; position < text.size(); ++position) {
            for (const char wrong : {'\0', '"', '{', ']', '9', '\\', '\xff'}) {
                QByteArray damaged = text;
                damaged[position] = wrong;
                const Result<SceneReading> reading = readScene(damaged);
                if (!reading)
                    QVERIFY(!reading.error().message().isEmpty());
            }
        }
    }

    void refusesNestingWithoutEnd()
    {
        QVERIFY(!readScene(QByteArray(100000, '[')).isOk());
        QVERIFY(!readScene(QByteArray(100000, '[') + QByteArray(100000, ']')).isOk());
    }

    void readsBackWhatItWrote_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 200; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void readsBackWhatItWrote()
    {
        QFETCH(quint32, seed);
        const Scene scene = randomScene(seed);

        const QByteArray text = writeScene(scene);
        const Result<SceneReading> reading = readScene(text);

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        QCOMPARE(reading->scene, scene);
        QVERIFY(reading->snaps.empty());
        QCOMPARE(writeScene(reading->scene), text);
    }

    void writesOnePrimitiveALine()
    {
        Scene scene;
        scene.triangles = {{{{{latticePixel(4, 5), {{255, 0, 0}}},
                              {latticePixel(58, 12), {{0, 255, 0}}},
                              {{26 * 256 + 128, 44 * 256}, {{0, 0, 255}}}}}}};

        QCOMPARE(writeScene(scene),
                 QByteArray(
                     "{\n"
                     "    \"pixelplumb\": 1,\n"
                     "    \"frame\": { \"width\": 64, \"height\": 48, \"background\": \"#000000\", "
                     "\"origin\": \"bottom-left\", \"pixelCentre\": \"integer\" },\n"
                     "    \"method\": \"column-scan\",\n"
                     "    \"arithmetic\": \"exact\",\n"
                     "    \"fillRule\": \"closed\",\n"
                     "    \"rounding\": \"nearest\",\n"
                     "    \"primitives\": [\n"
                     "        { \"triangle\": [[4, 5], [58, 12], [\"53/2\", 44]], "
                     "\"colors\": [\"#ff0000\", \"#00ff00\", \"#0000ff\"] }\n"
                     "    ]\n"
                     "}\n"));
    }

    void writesTheSameBytesInEveryLocale()
    {
        const Scene scene = randomScene(11);
        const QByteArray text = writeScene(scene);
        QLocale::setDefault(QLocale(QLocale::German));
        const QByteArray germanText = writeScene(scene);
        const bool readsInGerman = readScene(triangleAt("12.5")).isOk();
        QLocale::setDefault(QLocale::c());

        QCOMPARE(germanText, text);
        QVERIFY(readsInGerman);
    }

    void savesAndOpensAFile()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        const Scene scene = randomScene(3);

        QVERIFY(!writeSceneFile(path, scene));
        const Result<SceneReading> reading = readSceneFile(path);

        QVERIFY(reading.isOk());
        QCOMPARE(reading->scene, scene);
    }

    void namesTheFileThatCannotBeReadOrWritten()
    {
        const QTemporaryDir folder;
        const QString missing = folder.filePath(QStringLiteral("no/such.json"));

        const Result<SceneReading> reading = readSceneFile(missing);
        const std::optional<InputError> writing = writeSceneFile(missing, Scene());
        const Result<SceneReading> folderReading = readSceneFile(folder.path());

        QVERIFY(!reading.isOk());
        QCOMPARE(reading.error().place, missing);
        QVERIFY(writing.has_value());
        QCOMPARE(writing->place, missing);
        QVERIFY(!folderReading.isOk());
        QCOMPARE(folderReading.error().found, QStringLiteral("cannot be read: it is a folder"));
    }

    void keepsTheOldFileWhenWritingFails()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        QVERIFY(!writeFile(path, "old"));

        const std::optional<InputError> error = writeFile(path + QStringLiteral("/below"), "new");

        QVERIFY(error.has_value());
        QCOMPARE(*readFile(path), QByteArray("old"));
    }
};

QTEST_GUILESS_MAIN(tst_SceneFile)
#include "tst_scenefile.moc"
