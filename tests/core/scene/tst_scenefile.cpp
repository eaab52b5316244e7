// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/primitivefields.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/scenes/scenetext.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>

namespace tst_scenefile {

using namespace pixelplumb;

namespace {

QByteArray shapeScene(const QByteArray &primitives)
{
    const QByteArray text = "{ 'pixelplumb': 1, 'frame': { 'width': 16, 'height': 16 }, "
                            "'primitives': ["
        + primitives + "] }";
    return QByteArray(text).replace('\'', '"');
}

/// The keys of the lists by which scenes are read and written, some of them twice.
QStringList allKeys()
{
    QStringList keys = fieldNames<Scene>() + fieldNames<Appearance>() + fieldNames<FrameSpec>()
        + fieldNames<Motion>() + fieldNames<Material>() + fieldNames<HiddenTriangle>();
    for (const Projection projection : allProjections)
        keys += fieldNames(Camera{projection});
    for (const Light::Kind kind : {Light::Kind::Directional, Light::Kind::Positional})
        keys += fieldNames(Light{kind});
    for (int kind = int(PrimitiveKind::Point); kind <= int(PrimitiveKind::Text); ++kind) {
        Shape shape;
        shape.kind = PrimitiveKind(kind);
        shape.vertices.resize(1);
        keys += fieldNames(shape) + fieldNames(RoundFields{shape.kind});
    }
    for (const SolidKind kind : allSolidKinds) {
        Solid solid;
        solid.kind = kind;
        solid.corners.resize(16);
        keys += fieldNames(solid);
    }
    return keys;
}

} // namespace

/// Scenes written and read back, and their files.
class TestSceneFile : public QObject {
    Q_OBJECT

private slots:
    void theManualNamesEveryKey()
    {
        const QString manual = textInTree(u"resources/scene-file.md"_s);
        for (const QString &key : allKeys())
            QVERIFY2(manual.contains(u'`' + key + u'`') || manual.contains(u'"' + key + u'"'),
                     qPrintable(key));
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
        constexpr std::array wrongBytes = {'\0', '"', '{', ']', '9', '\\', '\xff'};
        forEachDamaged(writeScene(randomScene(7)), wrongBytes, [](const QByteArray &damaged) {
            const Result<SceneReading> reading = readScene(damaged);
            if (!reading)
                QVERIFY(!reading.error().message().isEmpty());
        });
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

    void hiddenPrimitivesKeepTheirPlacesAndAreNotDrawn()
    {
        const QByteArray text = shapeScene(
            "{ 'triangle': [[0, 0], [9, 0], [0, 9]], 'colors': ['#ff0000', '#ff0000', '#ff0000'], "
            "'z': [1, 2, 3], 'hidden': true }, "
            "{ 'triangle': [[1, 1], [9, 0], [0, 9]], 'colors': ['#00ff00', '#00ff00', '#00ff00'], "
            "'hidden': false }, "
            "{ 'line': [[0, 0], [9, 0]], 'colors': ['#ff0000', '#ff0000'] }, "
            "{ 'circle': { 'centre': [4, 4], 'radius': 3 }, 'color': '#ff0000', 'hidden': true }");

        const Result<SceneReading> reading = readScene(text);

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        const Scene &scene = reading->scene;
        QCOMPARE(scene.triangles.size(), std::size_t(1));
        QVERIFY(scene.attributes.empty());
        QCOMPARE(scene.shapes.size(), std::size_t(1));
        QCOMPARE(scene.hidden.size(), std::size_t(2));
        QCOMPARE(scene.hidden[0].place, std::size_t(0));
        QCOMPARE(scene.hidden[1].kind(), PrimitiveKind::Circle);
        QCOMPARE(scene.hidden[1].place, std::size_t(1));
        QCOMPARE(primitivesOnSamples(scene).size(), std::size_t(2));
        const QByteArray written = writeScene(scene);
        QCOMPARE(written.count("\"hidden\": true"), 2);
        QVERIFY(written.contains("\"z\": [1, 2, 3], \"hidden\": true }"));
        QCOMPARE(readScene(written)->scene, scene);
    }

    void whatIsNoHidingIsAnError_data()
    {
        QTest::addColumn<QByteArray>("primitives");
        QTest::addColumn<QString>("found");
        QTest::newRow("a number") << QByteArray(
            "{ 'line': [[0, 0], [9, 0]], 'colors': ['#ff0000', '#ff0000'], 'hidden': 1 }")
                                  << u"primitives[0].hidden: 1; expected true or false"_s;
        QTest::newRow("a triangle after a hidden shape") << QByteArray(
            "{ 'line': [[0, 0], [9, 0]], 'colors': ['#ff0000', '#ff0000'], 'hidden': true }, { "
            "'triangle': [[0, 0], [9, 0], [0, 9]], 'colors': ['#ff0000', '#ff0000', '#ff0000'] }")
                                                         << u"a triangle after "
                                                            "another primitive"_s;
    }
    void whatIsNoHidingIsAnError()
    {
        QFETCH(QByteArray, primitives);
        QFETCH(QString, found);

        const Result<SceneReading> reading = readScene(shapeScene(primitives));

        QVERIFY(!reading.isOk());
        QVERIFY2(reading.error().message().contains(found), qPrintable(reading.error().message()));
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
        const bool readsInGerman = readScene(sceneOfTriangleAt("12.5")).isOk();
        QLocale::setDefault(QLocale::c());

        QCOMPARE(germanText, text);
        QVERIFY(readsInGerman);
    }

    void savesAndOpensAFile()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_s);
        const Scene scene = randomScene(3);

        QVERIFY(!writeSceneFile(path, scene));
        const Result<SceneReading> reading = readSceneFile(path);

        QVERIFY(reading.isOk());
        QCOMPARE(reading->scene, scene);
    }

    void namesTheFileThatCannotBeReadOrWritten()
    {
        const QTemporaryDir folder;
        const QString missing = folder.filePath(u"no/such.json"_s);

        const Result<SceneReading> reading = readSceneFile(missing);
        const std::optional<InputError> writing = writeSceneFile(missing, Scene());
        const Result<SceneReading> folderReading = readSceneFile(folder.path());

        QVERIFY(!reading.isOk());
        QCOMPARE(reading.error().place, missing);
        QVERIFY(writing.has_value());
        QCOMPARE(writing->place, missing);
        QVERIFY(!folderReading.isOk());
        QCOMPARE(folderReading.error().found, u"cannot be read: it is a folder"_s);
    }

    void keepsTheOldFileWhenWritingFails()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_s);
        QVERIFY(!writeFile(path, "old"));

        const std::optional<InputError> error = writeFile(path + u"/below"_s, "new");

        QVERIFY(error.has_value());
        QCOMPARE(*readFile(path), QByteArray("old"));
    }
};

PIXELPLUMB_TEST(TestSceneFile)

} // namespace tst_scenefile

#include "tst_scenefile.moc"
