// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labfile.h"
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace tst_labcommand {

using namespace pixelplumb;

namespace {

/// One scene, two contenders: a second or less.
ProgramRun lab(const QStringList &options)
{
    return run(QStringList{"lab", defaultScene(), "--family", "own-scene", "--contender",
                           "column-scan:exact,column-scan:float32"}
               + options);
}

} // namespace

class TestLabCommand : public QObject {
    Q_OBJECT

private slots:
    void printsATableAndHowToDoItAgain()
    {
        const ProgramRun result = lab({});

        QCOMPARE(result.exitCode, 0);
        const QString text = QString::fromUtf8(result.output);
        QVERIFY2(text.contains(QStringLiteral("Own scene")), result.output.constData());
        QVERIFY2(text.contains(QStringLiteral("0 proved")), result.output.constData());
        QVERIFY2(text.contains(QStringLiteral("again: pixelplumb-cli lab ")),
                 result.output.constData());
    }

    void writesWhatCanBeRead()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("study.json"));

        const ProgramRun written = lab({"--format", "json", "-o", file});
        QFile opened(file);
        QVERIFY(opened.open(QIODevice::ReadOnly));
        const Result<Study> study = readStudy(opened.readAll());

        QCOMPARE(written.exitCode, 0);
        QVERIFY(bool(study));
        QCOMPARE(study->rows.size(), std::size_t(2));
    }

    void printsCsv()
    {
        const ProgramRun result = lab({"--format", "csv"});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.output.count('\n'), 3);
    }

    void theSameSeedWritesTheSameBytes_data()
    {
        QTest::addColumn<QString>("format");
        QTest::newRow("json") << QStringLiteral("json");
        QTest::newRow("csv") << QStringLiteral("csv");
    }
    void theSameSeedWritesTheSameBytes()
    {
        QFETCH(const QString, format);
        const auto write = [&](const QString &seed) {
            return run({"lab", "--family", "far", "--contender", "column-scan:float32",
                        "--accuracy-only", "--format", format, "--seed", seed});
        };

        const ProgramRun first = write(QStringLiteral("3"));
        const ProgramRun second = write(QStringLiteral("3"));
        const ProgramRun other = write(QStringLiteral("4"));

        QCOMPARE(first.exitCode, 0);
        QVERIFY2(first.output.contains("wrongTriangles"), first.output.constData());
        QVERIFY(first.output == second.output);
        QVERIFY(first.output != other.output);
    }

    void anInterruptedStudyWritesWhatItHas()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("study.json"));
        QProcess process;
        process.start(program(), {"lab", "--full", "--format", "json", "-o", file});
        QVERIFY(process.waitForStarted());
        QTest::qWait(1000); // its judging takes minutes

        ::kill(pid_t(process.processId()), SIGINT);

        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().contains("interrupted"));
        const auto study = readStudy(*readFile(file));
        QVERIFY(study);
        QVERIFY(!study->isComplete);
        QVERIFY(!study->rows.empty());
    }

    void aSceneWithoutTrianglesIsRefused()
    {
        const ProgramRun lines = run({"lab", sceneFile(QStringLiteral("lines.json"))});
        const ProgramRun none = run({"lab", "--family", "own-scene"});

        QCOMPARE(lines.exitCode, 2);
        QVERIFY2(lines.messages.contains("has no triangles"), lines.messages.constData());
        QCOMPARE(none.exitCode, 2);
        QVERIFY2(none.messages.contains("SCENE: is missing"), none.messages.constData());
    }

    void namesTheCheapestWithinABudget()
    {
        const ProgramRun result = lab({"--budget", "exact"});

        QCOMPARE(result.exitCode, 0);
        QVERIFY2(result.messages.contains("exact on own-scene: Column scan, exact"),
                 result.messages.constData());
    }

    void refusesWhatItDoesNotKnow_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("family") << QStringList{"--family", "tie"}
                                << QByteArray("did you mean ties?");
        QTest::newRow("contender") << QStringList{"--contender", "column-scan:float31"}
                                   << QByteArray("did you mean column-scan:float32?");
        QTest::newRow("budget") << QStringList{"--budget", "exakt"}
                                << QByteArray("did you mean exact?");
        QTest::newRow("format") << QStringList{"--format", "xml"}
                                << QByteArray("one of text, csv, json");
        QTest::newRow("seed") << QStringList{"--seed", "-1"} << QByteArray("--seed");
        QTest::newRow("extents") << QStringList{"--quick", "--full"}
                                 << QByteArray("expected one of them");
        QTest::newRow("accuracy as text")
            << QStringList{"--accuracy-only"} << QByteArray("expected --format json or csv");
        QTest::newRow("accuracy within a budget")
            << QStringList{"--accuracy-only", "--format", "csv", "--budget", "exact"}
            << QByteArray("--accuracy-only and --budget; expected one of them");
    }
    void refusesWhatItDoesNotKnow()
    {
        QFETCH(const QStringList, options);
        QFETCH(const QByteArray, message);

        const ProgramRun result = run(QStringList{"lab"} + options);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains(message), result.messages.constData());
    }

    void accuracyDrawsTheSameBytesAsExactArithmetic()
    {
        const ProgramRun chosen = run({"render", defaultScene(), "--accuracy", "exact", "-o", "-"});
        const ProgramRun exact
            = run({"render", defaultScene(), "--arithmetic", "exact", "-o", "-"});

        QCOMPARE(chosen.exitCode, 0);
        QVERIFY(chosen.output == exact.output);
        QVERIFY2(chosen.messages.contains("exact: column-scan:exact:fast, proved for"),
                 chosen.messages.constData());
    }

    void accuracyChoosesForRulesThatTheScenesMethodLacks()
    {
        const ProgramRun chosen = run({"render", defaultScene(), "--accuracy", "exact",
                                       "--fill-rule", "top-left", "-o", "-"});
        const ProgramRun exact = run({"render", defaultScene(), "--method", "row-walk",
                                      "--fill-rule", "top-left", "-o", "-"});

        QCOMPARE(chosen.exitCode, 0);
        QVERIFY2(chosen.messages.contains("exact: row-walk:exact, proved for"),
                 chosen.messages.constData());
        QVERIFY(chosen.output == exact.output);
    }

    void aBudgetIsAskedOfTheFamilyThatIsMeasured()
    {
        const ProgramRun result = run({"lab", "--family", "ties", "--budget", "exact",
                                       "--contender", "column-scan:exact,column-scan:float32"});

        QCOMPARE(result.exitCode, 0);
        QVERIFY2(result.messages.contains("exact on ties: Column scan, exact"),
                 result.messages.constData());
    }

    void accuracyStandsAlone()
    {
        const ProgramRun both = run({"render", defaultScene(), "--accuracy", "exact",
                                     "--arithmetic", "float32", "-o", "-"});
        const ProgramRun unknown
            = run({"render", defaultScene(), "--accuracy", "2-level", "-o", "-"});

        QCOMPARE(both.exitCode, 2);
        QVERIFY2(both.messages.contains("expected it alone"), both.messages.constData());
        QCOMPARE(unknown.exitCode, 2);
        QVERIFY2(unknown.messages.contains("did you mean 1-level?"), unknown.messages.constData());
    }
};

PIXELPLUMB_TEST(TestLabCommand)

} // namespace tst_labcommand

#include "tst_labcommand.moc"
