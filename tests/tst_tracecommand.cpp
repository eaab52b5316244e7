// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace pixelplumb;

/// Traces and the history of a pixel from the command line.
class TestTraceCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void tracesToStandardOutputAndToAFileAlike()
    {
        const QString path = m_folder.filePath(QStringLiteral("trace.csv"));

        const ProgramRun printed = run({"trace", defaultScene(), "--level", "pixel"});
        const ProgramRun written = run({"trace", defaultScene(), "--level", "pixel", "-o", path});

        QCOMPARE(printed.exitCode, 0);
        QCOMPARE(written.exitCode, 0);
        QVERIFY(printed.output.startsWith("step,primitive,x,y,R,"));
        QCOMPARE(*readFile(path), printed.output);
        QCOMPARE(written.output, QByteArray());
    }

    void columnsMayBeNamedWithBlanks()
    {
        const ProgramRun close = run({"trace", defaultScene(), "--columns", "x,y_B,y_T_error"});
        const ProgramRun wide = run({"trace", defaultScene(), "--columns", " x, y_B , y_T_error"});

        QCOMPARE(wide.exitCode, 0);
        QVERIFY(wide.output.startsWith("x,y_B,y_T_error\r\n"));
        QCOMPARE(wide.output, close.output);
    }

    void jsonDescribesTheChosenColumnsAlone()
    {
        const ProgramRun result = run(
            {"trace", defaultScene(), "--format", "json", "--columns", "pixels,step,y_T_error"});

        const QJsonDocument document = QJsonDocument::fromJson(result.output);
        QStringList described;
        for (const QJsonValue &column : document[QStringLiteral("columns")].toArray())
            described.append(column[QStringLiteral("id")].toString());
        // In the table's order; the step is no number of the method.
        QCOMPARE(described, (QStringList{"y_T", "pixels"}));
        QCOMPARE(document[QStringLiteral("rows")][0].toObject().keys(),
                 (QStringList{"pixels", "step", "y_T_error"}));
    }

    void leavesNoFileBehindThatCannotBeFinished()
    {
        const QString path = m_folder.filePath(QStringLiteral("none/trace.csv"));

        const ProgramRun result = run({"trace", defaultScene(), "-o", path});

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("cannot be written"), result.messages.constData());
    }

    void tellsWhoWroteAPixel()
    {
        const ProgramRun result = run({"pixel", defaultScene(), "27", "19"});

        QCOMPARE(result.exitCode, 0);
        QVERIFY2(
            result.output.startsWith("pixel (27, 19) #654c4e, as the truth\ntriangle 0, step "),
            result.output.constData());
        QVERIFY(
            QString::fromUtf8(result.output).contains(QStringLiteral("R = 100 1255/1299 → 101")));
    }

    void namesTheSpanAsTheWindowDoes()
    {
        const auto lineOf = [](const char *method, const char *x, const char *y) {
            const ProgramRun result = run({"pixel", defaultScene(), x, y, "--method", method});
            return QString::fromUtf8(result.output).section(u'\n', 2, 2).section(u':', 0, 0);
        };

        QCOMPARE(lineOf("column-scan", "20", "19"), QStringLiteral("    column 20, first half"));
        QCOMPARE(lineOf("column-scan", "50", "19"), QStringLiteral("    column 50, second half"));
        QCOMPARE(lineOf("row-walk", "27", "30"), QStringLiteral("    row 30, first trapezoid"));
    }

    void tellsWhichEdgeRefusesAPixel()
    {
        const ProgramRun result = run({"pixel", defaultScene(), "0", "0", "--json"});

        QCOMPARE(result.exitCode, 0);
        const QJsonDocument document = QJsonDocument::fromJson(result.output);
        const QJsonValue attempt = document[QStringLiteral("attempts")][0];
        QCOMPARE(document[QStringLiteral("colour")].toString(), QStringLiteral("#000000"));
        QCOMPARE(attempt[QStringLiteral("written")].toBool(true), false);
        QCOMPARE(attempt[QStringLiteral("edges")].toArray().size(), qsizetype(3));
        QCOMPARE(attempt[QStringLiteral("edges")][0][QStringLiteral("accepts")].toBool(true),
                 false);
        const QJsonValue distance
            = attempt[QStringLiteral("edges")][0][QStringLiteral("alongColumn")];
        QCOMPARE(distance[QStringLiteral("fraction")].toString(), QStringLiteral("-121/27"));
        QCOMPARE(distance[QStringLiteral("decimal")].toDouble(), -121.0 / 27);
    }

    void takesNegativeCoordinates()
    {
        const QByteArray scene
            = QByteArray(sceneOfSize(8, 8))
                  .replace("\"height\": 8", "\"height\": 8, \"firstPixel\": [-4, -4]");

        const ProgramRun result = run({"pixel", "-", "-3", "-2", "--json"}, scene);

        QCOMPARE(result.exitCode, 0);
        const QJsonDocument document = QJsonDocument::fromJson(result.output);
        QCOMPARE(document[QStringLiteral("x")].toInt(), -3);
        QCOMPARE(document[QStringLiteral("y")].toInt(), -2);
        QVERIFY(document[QStringLiteral("attempts")][0][QStringLiteral("written")].toBool());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestTraceCommand)
#include "tst_tracecommand.moc"
