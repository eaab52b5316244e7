// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programrun.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

namespace tst_checkcommand {

using namespace pixelplumb;

/// Hard cases checked from the command line.
class TestCheckCommand : public QObject {
    Q_OBJECT

private slots:
    void checksAllHardCases()
    {
        const ProgramRun result = run({"check", testData("hard_cases.json")});

        QCOMPARE(result.exitCode, 0);
        const QList<QByteArray> lines = result.output.trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(83));
        QCOMPARE(lines.front(), QByteArray("pass  sliver_unimodular_1999  50 of 50"));
        QCOMPARE(lines.back(), QByteArray("82 cases: 82 passed, 0 fell short, 0 skipped"));
    }

    void endsWithOneWhenACaseFallsShort()
    {
        const QString cases = testData("hard_cases.json");

        const QStringList arguments = {"check",        cases,     "--method",    "column-scan",
                                       "--arithmetic", "float32", "--fill-rule", "closed"};

        const ProgramRun text = run(arguments);
        const ProgramRun json = run(arguments + QStringList{"--json"});

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

        const ProgramRun result
            = run({"check", "-", "--method", "column-scan", "--arithmetic", "all"}, oneCase);

        QCOMPARE(result.exitCode, 0);
        // Five arithmetics under closed; the case says nothing about half-open-column.
        QCOMPARE(result.output,
                 QByteArray("pass  small  5 of 5\n1 cases: 1 passed, 0 fell short, 0 skipped\n"));
    }
};

PIXELPLUMB_TEST(TestCheckCommand)

} // namespace tst_checkcommand

#include "tst_checkcommand.moc"
