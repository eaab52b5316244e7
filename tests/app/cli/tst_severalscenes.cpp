// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

namespace tst_severalscenes {

using namespace pixelplumb;

/// Several scenes in one call of the headless program, and folders to write to.
class TestSeveralScenes : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void aFolderGetsThePictureOfEachScene()
    {
        const QString folder = m_folder.filePath(QStringLiteral("pictures/"));

        const ProgramRun result = run(
            {"render", defaultScene(), sceneFile(QStringLiteral("sliver.json")), "-o", folder});

        QCOMPARE(result.exitCode, 0);
        for (const QString &scene : {QStringLiteral("default"), QStringLiteral("sliver")})
            QCOMPARE(QImage(folder + scene + QStringLiteral(".png")), pictureAlone(scene));
    }

    void aSceneThatCannotBeReadDoesNotKeepTheOthersBack()
    {
        const QString folder = m_folder.filePath(QStringLiteral("some/"));

        const ProgramRun result = run({"render", "/nowhere.json", defaultScene(), "-o", folder});

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("/nowhere.json: cannot be read"),
                 result.messages.constData());
        QCOMPARE(QImage(folder + QStringLiteral("default.png")),
                 pictureAlone(QStringLiteral("default")));
    }

    void severalScenesNeedAFolderAndNamesOfTheirOwn_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("one file") << QStringList{defaultScene(), defaultScene(), "-o", "a.png"}
                                  << QByteArray("-o a.png: is one file for 2 scenes; expected a "
                                                "folder, such as a/");
        QTest::newRow("one name") << QStringList{defaultScene(), defaultScene(), "-o", "%1"}
                                  << QByteArray("would both be");
        QTest::newRow("no name") << QStringList{"-", "-o", "%1"}
                                 << QByteArray("standard input has no name in a folder");
    }
    void severalScenesNeedAFolderAndNamesOfTheirOwn()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, message);
        arguments.replaceInStrings(QStringLiteral("%1"), m_folder.path() + u'/');

        const ProgramRun result = run(QStringList{"render"} + arguments);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains(message), result.messages.constData());
    }

    void aFolderGetsTheTableOfEachScene()
    {
        const QString folder = m_folder.filePath(QStringLiteral("tables/"));

        const ProgramRun result = run(
            {"trace", defaultScene(), sceneFile(QStringLiteral("sliver.json")), "-o", folder});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(*readFile(folder + QStringLiteral("default.csv")),
                 run({"trace", defaultScene()}).output);
        QVERIFY(QFile::exists(folder + QStringLiteral("sliver.csv")));
    }

private:
    static QImage pictureAlone(const QString &scene)
    {
        const ProgramRun alone
            = run({"render", sceneFile(scene + QStringLiteral(".json")), "-o", "-"});
        return QImage::fromData(alone.output, "PNG");
    }

    QTemporaryDir m_folder;
};

PIXELPLUMB_TEST(TestSeveralScenes)

} // namespace tst_severalscenes

#include "tst_severalscenes.moc"
