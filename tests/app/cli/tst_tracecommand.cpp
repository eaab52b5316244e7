// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace tst_tracecommand {

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

    void columnsMayBeNamedAsTheTextHeadsThem()
    {
        const QStringList text = {"trace", defaultScene(), "--format", "text", "--columns"};
        const ProgramRun byName = run(text + QStringList{"x,first_row,delta_R,pixels,first_R"});
        const ProgramRun byTitle = run(text + QStringList{"x,⌈y_B⌉,ΔR,px,first R"});
        QCOMPARE(byTitle.exitCode, 0);
        QVERIFY(byTitle.output.contains("⌈y_B⌉"));
        QCOMPARE(byTitle.output, byName.output);

        const QString line = sceneFile(QStringLiteral("lines.json"));
        const ProgramRun decisions
            = run({"trace", line, "--method", "line-bresenham", "--columns", "p_k₊₁"});
        QCOMPARE(decisions.exitCode, 0);
        QVERIFY(decisions.output.startsWith("p_next\r\n"));

        const ProgramRun twice = run(text + QStringList{"ΔR,delta_R"});
        QCOMPARE(twice.exitCode, 2);
        QVERIFY(twice.messages.contains("named twice"));
    }

    void whereALineIsBesideAPixelIsAFraction()
    {
        const QByteArray scene = R"({ "pixelplumb": 1, "frame": { "width": 16, "height": 8 },
            "primitives": [ { "line": [[1, 1], [11, 4]], "colors": ["#ff0000", "#00ff00"] } ] })";
        const ProgramRun table
            = run({"trace", "-", "--method", "line-bresenham", "--columns",
                   "y_line,y_line_exact,d_lower_exact,d_upper_exact", "--x", "2"},
                  scene);
        QCOMPARE(table.exitCode, 0);
        QCOMPARE(table.output,
                 QByteArray("y_line,y_line_exact,d_lower_exact,d_upper_exact\r\n"
                            "1.3,13/10,3/10,7/10\r\n"));
    }

    void aFilledOutlineOnOneLineHasNoArea()
    {
        const QByteArray scene = R"({ "pixelplumb": 1, "frame": { "width": 16, "height": 8 },
            "primitives": [
                { "triangle": [[1, 1], [9, 5], [5, 3]], "colors": ["#ff0000", "#00ff00", "#0000ff"] },
                { "triangle": [[1, 1], [9, 5], [5, 4]], "colors": ["#ff0000", "#00ff00", "#0000ff"] }
            ] })";
        const ProgramRun table = run({"trace", "-", "--method", "midpoint-outline-fill", "--level",
                                      "setup", "--columns", "zero_area"},
                                     scene);
        QCOMPARE(table.output, QByteArray("zero_area\r\ntrue\r\nfalse\r\n"));
    }

    void thatThereAreNoStagesIsSaid()
    {
        const ProgramRun flat = run({"trace", defaultScene(), "--level", "stage"});
        const ProgramRun solid = run(
            {"trace", sceneFile(QStringLiteral("projected-triangle.json")), "--level", "stage"});
        QCOMPARE(flat.exitCode, 0);
        QVERIFY2(flat.messages.contains("default.json: no stages: there is no solid in it"),
                 flat.messages.constData());
        QCOMPARE(solid.messages, QByteArray());
    }

    void everyTitleOfATextTableNamesItsColumn()
    {
        const ProgramRun whole = run({"trace", defaultScene(), "--format", "text"});
        const QString header = QString::fromUtf8(whole.output).section(u'\n', 0, 0);
        const QStringList titles
            = header.split(QRegularExpression(QStringLiteral("\\s{2,}")), Qt::SkipEmptyParts);
        QVERIFY(titles.size() > 10);
        const ProgramRun named
            = run({"trace", defaultScene(), "--format", "text", "--columns", titles.join(u',')});
        QCOMPARE(named.exitCode, 0);
        QCOMPARE(named.output, whole.output);
    }

    void printsTheRowsOfOneTriangleColumnOrRow_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("column");
        QTest::addColumn<QByteArray>("value");
        QTest::newRow("a triangle's set-up") << QStringList{"--level", "setup", "--triangle", "1"}
                                             << QByteArray("primitive") << QByteArray("1");
        QTest::newRow("a triangle's columns")
            << QStringList{"--triangle", "1"} << QByteArray("primitive") << QByteArray("1");
        QTest::newRow("a column") << QStringList{"--x", "12"} << QByteArray("x")
                                  << QByteArray("12");
        QTest::newRow("a column's pixels")
            << QStringList{"--level", "pixel", "--x", "12"} << QByteArray("x") << QByteArray("12");
        QTest::newRow("a row's pixels")
            << QStringList{"--level", "pixel", "--y", "9"} << QByteArray("y") << QByteArray("9");
        QTest::newRow("a row") << QStringList{"--method", "row-walk", "--fill-rule",
                                              "closed",   "--y",      "9"}
                               << QByteArray("y") << QByteArray("9");
    }
    void printsTheRowsOfOneTriangleColumnOrRow()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, column);
        QFETCH(QByteArray, value);
        QStringList whole = options;
        whole.remove(whole.size() - 2, 2);
        const QString scene = sceneFile(QStringLiteral("shared-edge.json"));

        const QList<QByteArray> all = run(QStringList{"trace", scene} + whole).output.split('\n');
        const ProgramRun chosen = run(QStringList{"trace", scene} + options);

        const qsizetype place = all[0].trimmed().split(',').indexOf(column);
        QVERIFY(place >= 0);
        QList<QByteArray> expected = {all[0]};
        for (const QByteArray &line : all.sliced(1)) {
            if (line.isEmpty() || line.split(',').at(place) == value)
                expected.append(line);
        }
        QCOMPARE(chosen.exitCode, 0);
        QVERIFY(expected.size() > 2);
        QCOMPARE(chosen.output.split('\n'), expected);
    }

    void refusesRowsThatTheTableDoesNotHave_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("message");
        const auto row
            = [](const char *name, const QStringList &options, const QByteArray &message) {
                  QTest::newRow(name) << options << message;
              };
        row("no such triangle", {"--triangle", "7"},
            "--triangle: 7 is no primitive of the scene; expected 0 … 0");
        row("outside the frame", {"--x", "-1"}, "--x: -1 is outside the frame; expected 0 … 63");
        row("no number", {"--x", "left"}, "--x: “left” is no whole number");
        row("rows of a column scan", {"--y", "3"}, "--y: “column-scan” walks along no such rows");
        row("columns of a row walk", {"--method", "row-walk", "--x", "3"},
            "--x: “row-walk” walks along no such columns");
        row("set-up has no place", {"--level", "setup", "--x", "3"},
            "--x: a primitive's set-up has no place; expected --level column or --level pixel");
    }
    void refusesRowsThatTheTableDoesNotHave()
    {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, message);

        const ProgramRun result = run(QStringList{"trace", defaultScene()} + options);

        QCOMPARE(result.exitCode, 2);
        QCOMPARE(result.output, QByteArray());
        QVERIFY2(result.messages.contains(message), result.messages.constData());
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

PIXELPLUMB_TEST(TestTraceCommand)

} // namespace tst_tracecommand

#include "tst_tracecommand.moc"
