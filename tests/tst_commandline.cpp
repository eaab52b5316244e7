// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

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
                                << "Usage: pixelplumb-cli render [options] SCENE\n"
                                << "--ascii";
        QTest::newRow("trace") << QStringList{"trace", "--help"}
                               << "Usage: pixelplumb-cli trace [options] SCENE\n"
                               << "--level";
        QTest::newRow("pixel") << QStringList{"pixel", "-h"}
                               << "Usage: pixelplumb-cli pixel [options] SCENE X Y\n"
                               << "--json";
        QTest::newRow("methods") << QStringList{"methods", "--help"}
                                 << "Usage: pixelplumb-cli methods [options]\n"
                                 << "--json";
        QTest::newRow("check") << QStringList{"check", "--help"}
                               << "Usage: pixelplumb-cli check [options] CASES\n"
                               << "--arithmetic";
        QTest::newRow("version") << QStringList{"--version"} << "pixelplumb-cli "
                                 << "0";
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
        row("one too many", {"render", defaultScene(), "again", "--ascii"},
            "unexpected argument “again”");
        row("methods takes none", {"methods", "all"}, "unexpected argument “all”");
        row("value missing", {"render", defaultScene(), "-o"}, "Missing value after '-o'");
        row("nothing to do", {"render", defaultScene()},
            "nothing to do; expected -o FILE, --ascii or both");
        row("two results on stdout", {"render", defaultScene(), "--ascii", "-o", "-"},
            "-o - and --ascii both need standard output");
        row("unknown picture", {"render", defaultScene(), "-o", "out.jpeg2"},
            "unknown kind of picture; expected a name that ends in .png, .bmp, .ppm");
        row("method", {"render", defaultScene(), "--ascii", "--method", "colum-scan"},
            "--method: unknown name “colum-scan”; did you mean column-scan?");
        row("arithmetic", {"trace", defaultScene(), "--arithmetic", "float"},
            "--arithmetic: unknown name “float”; did you mean float32?; expected one of exact, "
            "float32, "
            "float64, fixed16.16, fixed32.32");
        row("fill rule", {"trace", defaultScene(), "--fill-rule", "half-open"},
            "--fill-rule: unknown name “half-open”");
        row("rule that the method does not keep",
            {"trace", defaultScene(), "--fill-rule", "top-left"},
            "cannot keep the fill rule “top-left”: a column ends at its two bounds whatever edge "
            "they "
            "belong to; it keeps closed, half-open-column");
        row("rounding", {"trace", defaultScene(), "--rounding", "down"},
            "expected one of nearest, truncate");
        row("level", {"trace", defaultScene(), "--level", "row"}, "expected column or pixel");
        row("format", {"trace", defaultScene(), "--format", "cvs"},
            "did you mean csv?; expected csv or json");
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
               {"binary", QByteArray(300, '\xff'), "-, line 1, column 2: "},
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
        QVERIFY(text.output.startsWith("column-scan: Column scan\n"));
        const QJsonArray list = QJsonDocument::fromJson(json.output).array();
        QCOMPARE(std::size_t(list.size()), methods().size());
        QCOMPARE(list[0][QStringLiteral("id")].toString(), QStringLiteral("column-scan"));
        QVERIFY(list[0][QStringLiteral("arithmetics")].toArray().contains(
            QStringLiteral("fixed16.16")));
        QVERIFY(list[0][QStringLiteral("fillRules")].toArray().contains(
            QStringLiteral("half-open-column")));
    }
};

QTEST_GUILESS_MAIN(TestCommandLine)
#include "tst_commandline.moc"
