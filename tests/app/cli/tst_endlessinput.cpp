// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/assignment.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

namespace tst_endlessinput {

using namespace pixelplumb;

/// Input that never ends, or never begins.
class TestEndlessInput : public QObject {
    Q_OBJECT

private slots:
    void isReadToALimitAndNoFurther_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("limit");
        const QString megabytes = u"cannot be read: it is larger than 256 MiB"_s;
        const auto row = [](const QStringList &arguments, const QString &limit) {
            QTest::newRow(qPrintable(arguments.join(u' '))) << arguments << limit;
        };
        for (const char *input : {"-", "/dev/zero"}) {
            const QString name = QString::fromLatin1(input);
            row({"render", name, "--ascii"}, megabytes);
            row({"check", name}, megabytes);
            row({"try", "--scene", name, "true"}, megabytes);
            row({"grade", ".", "--assignment", name, "-o", "never"}, megabytes);
            const QString larger = u"cannot be read: it is larger than 1025 MiB"_s;
            row({"diff", name, defaultScene()}, larger);
            row({"diagnose", name, "--scene", defaultScene()}, larger);
        }
    }
    /// With at most 4 GiB of addresses.
    void isReadToALimitAndNoFurther()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, limit);
        QProcess process;
        process.setStandardInputFile(u"/dev/zero"_s);
        process.start("/bin/sh",
                      QStringList{"-c", "ulimit -v 4194304; exec \"$0\" \"$@\"", program()}
                          + arguments);
        QVERIFY(process.waitForFinished(600'000));

        const QByteArray messages = process.readAllStandardError();
        QVERIFY2(process.exitCode() == 2, messages.constData());
        QVERIFY2(QString::fromUtf8(messages).contains(limit), messages.constData());
    }

    void aPipeThatAPersonNamesIsRead()
    {
        QProcess process;
        process.start("/bin/sh",
                      {"-c",
                       "mkfifo \"$2/pipe\" && cat \"$1\" > \"$2/pipe\" & sleep 1; "
                       "exec \"$0\" trace \"$2/pipe\"",
                       program(), defaultScene(), m_folder.path()});
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(process.readAllStandardOutput(), run({"trace", defaultScene()}).output);
    }

    void whatNobodyNamedIsNotWaitedFor()
    {
        const QString pipe = m_folder.filePath(u"scene.json"_s);
        QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        const QString refusal = u"it is a pipe or a device"_s;
        const auto assignment = readAssignment(R"({ "pixelplumbAssignment": 1, "name": "",
            "scenes": [ { "name": "a", "scene": "scene.json" } ] })",
                                               m_folder.path());
        QVERIFY(!assignment);
        QVERIFY2(assignment.error().message().contains(refusal),
                 qPrintable(assignment.error().message()));
        QVERIFY(readSceneFile(pipe).error().message().contains(refusal)); // as the window does
    }

    void aDrawingIsNoTexture()
    {
        const QString drawing = m_folder.filePath(u"drawing.svg"_s);
        QVERIFY(!writeFile(drawing,
                           "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"4\" height=\"4\" "
                           "xmlns:xlink=\"http://www.w3.org/1999/xlink\"><image "
                           "xlink:href=\"/dev/zero\"/></svg>"));
        const Result<SceneReading> reading
            = readScene(R"({ "pixelplumb": 1, "frame": { "width": 8, "height": 8 },
                "materials": { "a": { "texture": "drawing.svg" } }, "primitives": [] })",
                        {}, m_folder.path());
        QVERIFY(!reading);
    }

private:
    QTemporaryDir m_folder;
};

PIXELPLUMB_TEST(TestEndlessInput)

} // namespace tst_endlessinput

#include "tst_endlessinput.moc"
