// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

namespace tst_commandline {

using namespace pixelplumb;

/// What all commands share: help, hints at wrong arguments, refusals of unreadable input.
class TestCommandLine : public QObject {
    Q_OBJECT

private slots:
    void saysWhatItCanDo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("beginning");
        QTest::addColumn<QString>("within");
        QTest::newRow("help") << QStringList{"--help"} << "Usage: pixelplumb-cli COMMAND"
                              << "check ";
        QTest::newRow("h") << QStringList{"-h"} << "Usage: pixelplumb-cli COMMAND"
                           << "render ";
        QTest::newRow("render") << QStringList{"render", "--help"}
                                << "Usage: pixelplumb-cli render [options] SCENE...\n"
                                << "--ascii";
        QTest::newRow("trace") << QStringList{"trace", "--help"}
                               << "Usage: pixelplumb-cli trace [options] SCENE...\n"
                               << "--level";
        QTest::newRow("pixel") << QStringList{"pixel", "-h"}
                               << "Usage: pixelplumb-cli pixel [options] SCENE X Y\n"
                               << "--json";
        QTest::newRow("methods") << QStringList{"methods", "--help"}
                                 << "Usage: pixelplumb-cli methods [options] [NAME]\n"
                                 << "--json";
        QTest::newRow("check") << QStringList{"check", "--help"}
                               << "Usage: pixelplumb-cli check [options] CASES\n"
                               << "--arithmetic";
        QTest::newRow("help alone") << QStringList{"help"} << "Usage: pixelplumb-cli COMMAND"
                                    << "help ";
        QTest::newRow("help of help")
            << QStringList{"help", "help"} << "Usage: pixelplumb-cli COMMAND"
            << "help COMMAND";
    }
    void saysWhatItCanDo()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, beginning);
        QFETCH(QString, within);

        const ProgramRun result = run(arguments);

        QCOMPARE(result.exitCode, 0);
        const QString output = QString::fromUtf8(result.output);
        QVERIFY2(output.startsWith(beginning) && output.contains(within),
                 result.output.constData());
        QCOMPARE(result.messages, QByteArray());
    }

    void theVersionIsANumberAndInACheckoutTheCommit()
    {
        const ProgramRun result = run({"--version"});

        QCOMPARE(result.exitCode, 0);
        const QRegularExpression form(R"(^pixelplumb-cli \d+\.\d+\.\d+( \([\w.-]+\))?\n$)");
        QVERIFY2(form.match(QString::fromUtf8(result.output)).hasMatch(),
                 result.output.constData());
    }

    void helpOfACommandIsWhatItSaysItself()
    {
        const QString all = QString::fromUtf8(run({"help"}).output);
        QCOMPARE(all.toUtf8(), run({"--help"}).output);
        int commands = 0;
        const QString list = all.section(QStringLiteral("Commands:\n"), 1).section("\n\n", 0, 0);
        for (const QString &row : list.split(u'\n')) {
            const QString command = row.simplified().section(u' ', 0, 0);
            const ProgramRun help = run({"help", command});

            QCOMPARE(help.exitCode, 0);
            QVERIFY(help.output.startsWith("Usage: pixelplumb-cli "));
            QCOMPARE(help.output, run({command, "--help"}).output);
            ++commands;
        }
        QVERIFY(commands >= 7);
    }

    void refusesAWrongCommandLineWithAHint_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QStringList &arguments, const char *message) {
            QTest::newRow(name) << arguments << QString::fromUtf8(message);
        };
        row("nothing", {}, "pixelplumb-cli: a command is missing");
        row("typing error", {"rendre", defaultScene()},
            "unknown command “rendre”; did you mean render?");
        row("no command at all", {"xyzzy"}, "unknown command “xyzzy”\n");
        row("option for a command", {"--versoin"},
            "unknown option --versoin; did you mean --version?");
        row("unknown option", {"render", defaultScene(), "--asci"},
            "pixelplumb-cli render: unknown option --asci; did you mean --ascii?");
        row("unknown short option", {"render", defaultScene(), "-x"}, "unknown option -x");
        row("no scene", {"render", "--ascii"}, "SCENE is missing");
        row("one too many", {"pixel", defaultScene(), "1", "2", "again"},
            "unexpected argument “again”");
        row("no such method", {"methods", "colum-scan"},
            "unknown method “colum-scan”; did you mean column-scan?");
        row("methods takes one", {"methods", "column-scan", "all"}, "unexpected argument “all”");
        row("picture twice", {"render", defaultScene(), "-o", "a.png", "--output", "b.png"},
            "pixelplumb-cli render: -o a.png and --output b.png; expected --output once");
        row("switch twice", {"plan", defaultScene(), "--json", "--json"},
            "pixelplumb-cli plan: --json and --json; expected --json once");
        row("number twice", {"trace", defaultScene(), "--x", "-1", "--x", "-1"},
            "pixelplumb-cli trace: --x -1 and --x -1; expected --x once");
        row("value missing", {"render", defaultScene(), "-o"}, "Missing value after '-o'");
        row("nothing to do", {"render", defaultScene()},
            "nothing to do; expected -o FILE, --ascii or both");
        row("two results on stdout", {"render", defaultScene(), "--ascii", "-o", "-"},
            "-o - and --ascii both need standard output");
        row("unknown picture", {"render", defaultScene(), "-o", "out.jpeg2"},
            "unknown kind of picture; expected a name that ends in .png, .bmp, .ppm");
        row("method", {"render", defaultScene(), "--ascii", "--method", "colum-scan"},
            "--method: unknown name “colum-scan”; did you mean column-scan?; expected a method "
            "that "
            "“pixelplumb-cli methods” lists");
        row("method for a side", {"counterexample", "colum-scan", "truth"},
            "ONE: unknown method, truth or defect “colum-scan”; did you mean column-scan?");
        row("no program", {"counterexample", "program:", "truth"},
            "ONE: “program:” names no program; expected “program:COMMAND”");
        row("time of no program", {"counterexample", "column-scan", "truth", "--time", "5"},
            "--time: says how a program is run, and none is named; expected “program:COMMAND” "
            "among column-scan, truth");
        row("memory of no program", {"invariants", "column-scan", "--memory", "64"},
            "--memory: says how a program is run, and none is named");
        row("memory in which nothing starts",
            {"try", "--scene", defaultScene(), "--memory", "15", "true"},
            "--memory: no program starts in 15 MiB; expected 16 … 1048576, or 0 for no limit");
        row("arithmetic", {"trace", defaultScene(), "--arithmetic", "float"},
            "--arithmetic: unknown name “float”; did you mean float32?; expected one of exact, "
            "float32, "
            "float64, fixed16.16, fixed32.32");
        row("fill rule", {"trace", defaultScene(), "--fill-rule", "half-open"},
            "--fill-rule: unknown name “half-open”");
        row("rule that the method does not keep",
            {"trace", defaultScene(), "--method", "column-scan", "--fill-rule", "top-left"},
            "cannot keep the fill rule “top-left”: a column ends at its two bounds whatever edge "
            "they "
            "belong to; it keeps closed, half-open-column, open");
        row("rounding", {"trace", defaultScene(), "--rounding", "down"},
            "expected one of nearest, truncate");
        row("level", {"trace", defaultScene(), "--level", "row"}, "expected setup, column, pixel");
        row("format", {"trace", defaultScene(), "--format", "cvs"},
            "did you mean csv?; expected text, csv, json");
        row("column", {"trace", defaultScene(), "--columns", "x,y_Q"},
            "--columns: unknown column “y_Q”; did you mean y_B?; expected one of step, ");
        row("no column", {"trace", defaultScene(), "--columns", ""},
            "--columns is empty; expected its names");
        row("no column after a comma", {"trace", defaultScene(), "--columns", "x, "},
            "--columns: a name is missing");
        row("column twice", {"trace", defaultScene(), "--columns", "x,y_B, x"},
            "--columns: “x” is named twice; expected each column once");
        row("help of nothing known", {"help", "trase"},
            "help: unknown command “trase”; did you mean trace?");
        row("help of two", {"help", "trace", "render"}, "help: unexpected argument “render”");
        row("no row", {"pixel", defaultScene(), "3"}, "Y is missing: the pixel's row");
        row("x is no number", {"pixel", defaultScene(), "three", "4"},
            "X: “three” is no whole number; expected 0 … 63");
        row("x outside", {"pixel", defaultScene(), "64", "4"},
            "X: 64 is outside the frame; expected 0 … 63");
        row("y outside", {"pixel", defaultScene(), "4", "-1"},
            "Y: -1 is outside the frame; expected 0 … 47");
        row("nan", {"pixel", defaultScene(), "nan", "4"}, "X: “nan” is no whole number");
        row("beyond 64 bits", {"pixel", defaultScene(), "99999999999999999999", "4"},
            "is no whole number");
        row("check arithmetic", {"check", "cases.json", "--arithmetic", "exat"},
            "did you mean exact?");
        row("check rule without method",
            {"check", "cases.json", "--method", "column-scan", "--fill-rule", "off-screen-point"},
            "no method draws in this arithmetic under this rule");
    }
    void refusesAWrongCommandLineWithAHint()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, message);

        const ProgramRun result = run(arguments);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(QString::fromUtf8(result.messages).contains(message), result.messages.constData());
        QCOMPARE(result.output, QByteArray());
    }

    void everyCommandRefusesInputThatCannotBeRead_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("input");
        QTest::addColumn<QString>("message");
        const QByteArray whole = *readFile(defaultScene());
        const std::pair<const char *, QStringList> commandLines[]
            = {{"render", {"render", "-", "--ascii"}},
               {"trace", {"trace", "-"}},
               {"pixel", {"pixel", "-", "1", "1"}},
               {"check", {"check", "-"}}};
        const std::tuple<const char *, QByteArray, const char *> inputs[]
            = {{"nothing", "", "-, the input is empty; expected JSON"},
               {"cut short", whole.first(whole.size() / 2), "-, line "},
               {"binary", QByteArray(300, '\xff'), "-, line 1, column 1: "},
               {"a number", "7", "-, line 1"},
               {"wrong types", "{\"pixelplumb\": [], \"version\": {}, \"cases\": 3}",
                "-, line 1, column "},
               {"newer", "{\"pixelplumb\": 7, \"version\": 7}", "-, line 1, column "}};
        for (const auto &commandLine : commandLines) {
            for (const auto &[name, input, message] : inputs)
                QTest::addRow("%s, %s", commandLine.first, name)
                    << commandLine.second << input << QString::fromUtf8(message);
        }
    }
    void everyCommandRefusesInputThatCannotBeRead()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, input);
        QFETCH(QString, message);

        const ProgramRun result = run(arguments, input);

        QCOMPARE(result.exitCode, 2);
        const QString messages = QString::fromUtf8(result.messages)
                                     .replace(QStringLiteral("-: "), QStringLiteral("-, "));
        QVERIFY2(messages.contains(message), result.messages.constData());
        QCOMPARE(result.output, QByteArray());
    }

    void listsTheMethods()
    {
        const ProgramRun text = run({"methods"});
        const ProgramRun json = run({"methods", "--json"});

        QCOMPARE(text.exitCode, 0);
        QVERIFY2(text.output.startsWith("column-scan "), text.output.constData());
        QVERIFY(text.output.contains(" Column scan (triangle)\n"));
        QCOMPARE(std::size_t(text.output.count('\n')), methods().size());
        const QJsonArray list = QJsonDocument::fromJson(json.output).array();
        QCOMPARE(std::size_t(list.size()), methods().size());
        QCOMPARE(list[0][QStringLiteral("id")].toString(), QStringLiteral("column-scan"));
        QVERIFY(list[0][QStringLiteral("arithmetics")].toArray().contains(
            QStringLiteral("fixed16.16")));
        QVERIFY(list[0][QStringLiteral("fillRules")].toArray().contains(
            QStringLiteral("half-open-column")));
    }

    void tellsOneMethodWhole()
    {
        const ProgramRun text = run({"methods", "barycentric-all"});
        QCOMPARE(text.exitCode, 0);
        QVERIFY(text.output.startsWith("barycentric-all: "));
        QVERIFY(text.output.contains("\n  numbers of a sample\n"));
        QVERIFY(text.output.contains("\n  operations in float32, the triangle "));
        QVERIFY(text.output.contains("\n    divisions "));

        const ProgramRun json = run({"methods", "barycentric-all", "--json"});
        const QJsonObject whole = QJsonDocument::fromJson(json.output).object();
        QCOMPARE(whole[QStringLiteral("id")].toString(), QStringLiteral("barycentric-all"));
        // Three arithmetics, two triangles.
        const QJsonArray operations = whole[QStringLiteral("operations")].toArray();
        QCOMPARE(operations.size(), qsizetype(6));
        QCOMPARE(operations[0][QStringLiteral("arithmetic")].toString(), QStringLiteral("exact"));
        QVERIFY(operations[0][QStringLiteral("pixel")][QStringLiteral("comparisons")].toInt() > 0);
    }
};

PIXELPLUMB_TEST(TestCommandLine)

} // namespace tst_commandline

#include "tst_commandline.moc"
