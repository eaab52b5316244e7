// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/counterexample.h"
#include "core/methods/method.h"
#include "core/scene/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace tst_counterexample {

using namespace pixelplumb;

/// A small scene on which two programs differ is found.
class TestCounterExample : public QObject {
    Q_OBJECT

private slots:
    void aCounterExampleIsFoundAndShrunk_data()
    {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        QTest::addColumn<int>("largest"); // px
        const auto row = [](const char *one, const char *other, int largest) {
            QTest::addRow("%s, %s", one, other)
                << QString::fromLatin1(one) << QString::fromLatin1(other) << largest;
        };
        row("column-scan:float32", "truth", 64);
        row("column-scan:exact:open", "column-scan:exact:closed", 4);
        row("no-colour-pre-step", "column-scan", 9);
        row("truth", "divisor-plus-one", 9);
        row("parity", "column-scan", 9);
        row("line-bresenham", "one-step-short", 4);
        row("line-bresenham", "line-dda", 9);
    }
    void aCounterExampleIsFoundAndShrunk()
    {
        QFETCH(QString, one);
        QFETCH(QString, other);
        QFETCH(int, largest);
        const QTemporaryDir folder;
        const QStringList arguments = {QStringLiteral("counterexample"),
                                       one,
                                       other,
                                       QStringLiteral("-o"),
                                       folder.filePath(QStringLiteral("c.json")),
                                       QStringLiteral("--json")};

        const ProgramRun result = run(arguments);

        QCOMPARE(result.exitCode, 1);
        const QJsonDocument json = QJsonDocument::fromJson(result.output);
        QVERIFY(!json[QStringLiteral("pixels")].toArray().isEmpty());
        const auto reading = readSceneFile(folder.filePath(QStringLiteral("c.json")));
        QVERIFY(bool(reading));
        QVERIFY(reading->scene.frame.width * reading->scene.frame.height <= largest);
        QCOMPARE(run(arguments).output, result.output);
    }

    void nothingShrinksAnyMore()
    {
        Scene conventions;
        const Method &method = *methodNamed(QStringLiteral("column-scan"));
        const PictureSource right = sourceOf(Contender{&method, conventions.settings});
        const PictureSource wrong
            = sourceOf(QStringLiteral("divisor-plus-one"), {&method, conventions.settings});
        const CounterSearch search = findCounterExample(right, wrong, conventions, 3);
        QVERIFY(search.found.has_value());
        QVERIFY(tryScene(right, wrong, search.found->scene).example.has_value());
        QCOMPARE(shrunk(*search.found, right, wrong).scene, search.found->scene);
        QCOMPARE(tryScene(right, right, search.found->scene).outcome, SceneOutcome::Same);
    }

    void whoWaitsHearsOfTheShrinking()
    {
        Scene conventions;
        const Method &method = *methodNamed(QStringLiteral("column-scan"));
        const PictureSource right = sourceOf(Contender{&method, conventions.settings});
        const PictureSource wrong
            = sourceOf(QStringLiteral("divisor-plus-one"), {&method, conventions.settings});
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
        if (QStandardPaths::findExecutable(QStringLiteral("script")).isEmpty())
            QSKIP("there is no script(1), which gives a terminal");
        const QTemporaryDir folder;
        const QString slow = folder.filePath(QStringLiteral("slow"));
        QVERIFY(!writeFile(slow,
                           "#!/usr/bin/env python3\nimport json, sys, time\n"
                           "f = json.load(sys.stdin)['frame']\ntime.sleep(0.02)\n"
                           "print(('.' * f['width'] + chr(10)) * f['height'], end='')\n"));
        QVERIFY(QFile::setPermissions(slow, QFile::ReadOwner | QFile::ExeOwner));
        QProcess terminal;
        terminal.start(
            QStringLiteral("script"),
            {QStringLiteral("-qec"),
             QStringLiteral("'%1' counterexample column-scan 'program:%2'").arg(program(), slow),
             QStringLiteral("/dev/null")});
        QVERIFY(terminal.waitForFinished(120'000));

        const QByteArray shown = terminal.readAllStandardOutput();
        const qsizetype last = shown.lastIndexOf("\r\033[Kshrinking: ");
        QVERIFY2(last >= 0, shown.constData());
        const QByteArray behind = shown.mid(last + 1);
        const qsizetype erased = behind.indexOf("\r\033[K");
        QVERIFY2(erased > 0 && erased < behind.indexOf(" pixels, scene "), behind.constData());
    }

    void aCounterExampleTellsTheStepOfWhatNoKernelDraws()
    {
        const ProgramRun result
            = run({QStringLiteral("counterexample"), QStringLiteral("column-scan"),
                   QStringLiteral("last-sample-missing")});
        QCOMPARE(result.exitCode, 1);
        QVERIFY2(result.output.contains("with last-sample-missing parts at step 4, Pixel (0, 1): "
                                        "(0, 1) is left out"),
                 result.output);
    }

    void aProgramHasItsCounterExample()
    {
        // A raster of nothing: each triangle that covers a sample is one. It is started a hundred
        // times, and an interpreter that takes its time to start would take the test's.
        const QString program
            = QStringLiteral("program:awk -v dot=. \"/^frame/ { for (i = 0; i < $3; ++i) "
                             "{ for (j = 0; j < $2; ++j) printf dot; print nothing } }\"");
        const ProgramRun result
            = run({QStringLiteral("counterexample"), program, QStringLiteral("column-scan"),
                   QStringLiteral("--input"), QStringLiteral("lines"), QStringLiteral("--json")});
        QVERIFY2(result.exitCode == 1, result.messages.constData());
        const QJsonDocument json = QJsonDocument::fromJson(result.output);
        QVERIFY(json[QStringLiteral("pixels")].toArray().size() >= 1);
        QCOMPARE(
            json[QStringLiteral("scene")][QStringLiteral("frame")][QStringLiteral("width")].toInt(),
            2);
        // It draws nothing, and nothing can be compared.
        for (const QString &command :
             {QStringLiteral("counterexample"), QStringLiteral("invariants")}) {
            QStringList words = {command, QStringLiteral("program:ls /nowhere")};
            if (command == QStringLiteral("counterexample"))
                words.insert(2, QStringLiteral("column-scan"));
            const ProgramRun undrawn = run(words);
            QCOMPARE(undrawn.exitCode, 1);
            QVERIFY2(undrawn.messages.contains("exit code 2: /usr/bin/ls: cannot access"),
                     undrawn.messages.constData());
            QCOMPARE(
                run(words + QStringList{QStringLiteral("--time"), QStringLiteral("0")}).exitCode,
                2);
        }
    }

    void whereNoneIsFoundItSaysHowManyWereTried()
    {
        const ProgramRun result = run({QStringLiteral("counterexample"),
                                       QStringLiteral("column-scan"), QStringLiteral("truth")});
        QCOMPARE(result.exitCode, 0);
        QVERIFY2(result.output.contains("draw the same in 10081 scenes"),
                 result.output.constData());
        const ProgramRun unknown
            = run({QStringLiteral("counterexample"), QStringLiteral("no-color-pre-step"),
                   QStringLiteral("truth")});
        QCOMPARE(unknown.exitCode, 2);
        QVERIFY2(unknown.messages.contains("did you mean no-colour-pre-step"),
                 unknown.messages.constData());
        QVERIFY2(unknown.messages.contains("probes --list --method column-scan"),
                 unknown.messages.constData());
        QVERIFY2(unknown.messages.size() < 400, unknown.messages.constData());
    }
};

PIXELPLUMB_TEST(TestCounterExample)

} // namespace tst_counterexample

#include "tst_counterexample.moc"
