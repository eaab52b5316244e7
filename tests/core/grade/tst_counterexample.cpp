// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/counterexample.h"
#include "core/methods/method.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace tst_counterexample {

using namespace pixelplumb;

/// A small scene on which two programs differ is found. What is printed of it is in
/// tests/data/transcripts/counterexample.txt.
class TestCounterExample : public QObject {
    Q_OBJECT

private slots:
    void nothingShrinksAnyMore()
    {
        Scene conventions;
        const Method &method = *methodNamed(u"column-scan"_s);
        const PictureSource right = sourceOf(Contender{&method, conventions.settings});
        const PictureSource wrong
            = sourceOf(u"divisor-plus-one"_s, {&method, conventions.settings});
        const CounterSearch search = findCounterExample(right, wrong, conventions, 3);
        QVERIFY(search.found.has_value());
        QVERIFY(tryScene(right, wrong, search.found->scene).example.has_value());
        QCOMPARE(shrunk(*search.found, right, wrong).scene, search.found->scene);
        QCOMPARE(tryScene(right, right, search.found->scene).outcome, SceneOutcome::Same);
    }

    void whoWaitsHearsOfTheShrinking()
    {
        Scene conventions;
        const Method &method = *methodNamed(u"column-scan"_s);
        const PictureSource right = sourceOf(Contender{&method, conventions.settings});
        const PictureSource wrong
            = sourceOf(u"divisor-plus-one"_s, {&method, conventions.settings});
        std::vector<JobProgress> heard;
        const auto whole = findCounterExample(right, wrong, conventions, 3,
                                              [&heard](const JobProgress &progress) {
                                                  heard.push_back(progress);
                                                  return true;
                                              });
        const auto shrinking = std::ranges::find(heard, 0, &JobProgress::total);
        QVERIFY(shrinking != heard.end());
        QCOMPARE(shrinking->done, std::int64_t(1));
        QVERIFY(heard.back().total == 0 && heard.back().done > 1);

        const auto ended
            = findCounterExample(right, wrong, conventions, 3,
                                 [](const JobProgress &progress) { return progress.total > 0; });
        QVERIFY(ended.found.has_value()); // though it is not as small
        QVERIFY(tryScene(right, wrong, ended.found->scene).example.has_value());
        QVERIFY(!(ended.found->scene == whole.found->scene));
    }

    void onATerminalTheShrinkingIsSeenAndErasedBeforeTheResult()
    {
        if (QStandardPaths::findExecutable(u"script"_s).isEmpty())
            QSKIP("there is no script(1), which gives a terminal");
        const QTemporaryDir folder;
        const QString slow = folder.filePath(u"slow"_s);
        QVERIFY(!writeFile(slow,
                           "#!/usr/bin/env python3\nimport json, sys, time\n"
                           "f = json.load(sys.stdin)['frame']\ntime.sleep(0.02)\n"
                           "print(('.' * f['width'] + chr(10)) * f['height'], end='')\n"));
        QVERIFY(QFile::setPermissions(slow, QFile::ReadOwner | QFile::ExeOwner));
        QProcess terminal;
        terminal.start(u"script"_s,
                       {u"-qec"_s,
                        u"'%1' counterexample column-scan 'program:%2'"_s.arg(program(), slow),
                        u"/dev/null"_s});
        QVERIFY(terminal.waitForFinished(120'000));

        const QByteArray shown = terminal.readAllStandardOutput();
        const qsizetype last = shown.lastIndexOf("\r\033[Kshrinking: ");
        QVERIFY2(last >= 0, shown.constData());
        const QByteArray behind = shown.mid(last + 1);
        const qsizetype erased = behind.indexOf("\r\033[K");
        QVERIFY2(erased > 0 && erased < behind.indexOf(" pixels, scene "), behind.constData());
    }
};

PIXELPLUMB_TEST(TestCounterExample)

} // namespace tst_counterexample

#include "tst_counterexample.moc"
