// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

namespace tst_handedin {

using namespace pixelplumb;

namespace {

/// JSON with ' for ".
QByteArray quoted(const char *text) { return QByteArray(text).replace('\'', '"'); }

} // namespace

/// How long programs are waited for that students hand in. What else is said of them and of their
/// pictures is in tests/data/transcripts/handed-in.txt.
class TestHandedIn : public QObject {
    Q_OBJECT

private slots:
    void whoSleepsInOneSceneIsWaitedForLessInTheOthers()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(u"subs/one"_s));
        QVERIFY(!writeFile(folder.filePath("subs/one/main.py"), "import time\ntime.sleep(1000)\n"));
        QVERIFY(!writeFile(folder.filePath("white.json"),
                           quoted("{ 'pixelplumb': 1,"
                                  " 'frame': { 'width': 8, 'height': 6 }, 'primitives': ["
                                  " { 'triangle': [[1, 1], [6, 1], [1, 4]],"
                                  " 'colors': ['#ffffff', '#ffffff', '#ffffff'] } ] }")));
        QVERIFY(!writeFile(folder.filePath("a.json"),
                           quoted("{ 'pixelplumbAssignment': 1, 'name': 'a', 'scenes': ["
                                  " { 'name': 'first', 'scene': 'white.json' },"
                                  " { 'name': 'second', 'scene': 'white.json' } ],"
                                  " 'program': { 'seconds': 1 } }")));

        const ProgramRun graded = run({"grade", folder.filePath("subs"), "--assignment",
                                       folder.filePath("a.json"), "-o", folder.filePath("out")});

        QVERIFY2(graded.exitCode == 0, graded.messages.constData());
        const auto results
            = QJsonDocument::fromJson(*readFile(folder.filePath("out/results.json")));
        const QString sentences = results[u"submissions"_s][0][u"output"_s].toString();
        QVERIFY2(sentences.contains(
                     u"first: it was ended by the clock: for 4 s it was not seen to compute"_s),
                 qPrintable(sentences));
        QVERIFY2(sentences.contains(
                     u"second: it was ended by the clock: for 1 s it was not seen to compute"_s),
                 qPrintable(sentences));
        QVERIFY2(sentences.contains(u"second: it was given less time by the clock"_s),
                 qPrintable(sentences));
    }
};

PIXELPLUMB_TEST(TestHandedIn)

} // namespace tst_handedin

#include "tst_handedin.moc"
