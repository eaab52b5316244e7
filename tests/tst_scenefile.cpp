// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "tests/support/scenetext.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>

using namespace pixelplumb;

/// Scenes written and read back, and the files that hold them.
class TestSceneFile : public QObject {
    Q_OBJECT

private slots:
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

QTEST_GUILESS_MAIN(TestSceneFile)
#include "tst_scenefile.moc"
