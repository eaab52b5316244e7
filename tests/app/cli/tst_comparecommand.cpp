// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace tst_comparecommand {

using namespace pixelplumb;

namespace {

const QString tiesScene = sceneFile(QStringLiteral("ties-at-tenths.json"));

const QByteArray triangleAndLine
    = R"({ "pixelplumb": 1, "frame": { "width": 16, "height": 12 }, "method": "column-scan",
  "primitives": [
    { "triangle": [[1, 1], [9, 2], [3, 9]], "colors": ["#ff0000", "#00ff00", "#0000ff"] },
    { "line": [[0, 0], [15, 11]], "colors": ["#ffffff", "#ffffff"] } ] })";

ProgramRun compare(const QString &scene, const QStringList &options, const QByteArray &input = {})
{
    return run(QStringList{"compare", scene} + options, input);
}

} // namespace

class TestCompareCommand : public QObject {
    Q_OBJECT

private slots:
    void endsWithZeroWhereAllAgree()
    {
        const ProgramRun result = compare(defaultScene(), {"--methods", "column-scan:exact,truth"});

        QCOMPARE(result.exitCode, 0);
        QVERIFY2(result.output.endsWith("\nAll agree on every pixel.\n"),
                 result.output.constData());
        QVERIFY(result.output.contains("2 of 2    3072\n1 of 2       0\n"));
        QCOMPARE(result.messages, QByteArray());
    }

    void listsThePixelsThatDifferWithTheirReasons()
    {
        const ProgramRun result = compare(
            tiesScene, {"--methods", "truth:closed,column-scan:float32:closed", "--limit", "1"});

        QCOMPARE(result.exitCode, 1);
        const QString output = QString::fromUtf8(result.output);
        QVERIFY2(output.startsWith(
                     QStringLiteral("contender                     pixels  missing  extra  colour "
                                    " ≠1  ≠2\n1 truth closed ")),
                 result.output.constData());
        QVERIFY2(output.contains(QStringLiteral("\n  drift")), result.output.constData());
        QVERIFY2(output.contains(QStringLiteral(" instead of ")), result.output.constData());
        QVERIFY2(output.contains(QStringLiteral("\nand ")), result.output.constData());
    }

    void drawsWhereTheyDiffer()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("differences.png"));

        const ProgramRun result = compare(
            tiesScene,
            {"--methods", "truth:closed,column-scan:float32:closed", "--limit", "0", "-o", path});

        QCOMPARE(result.exitCode, 1);
        const QImage picture(path);
        int marked = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QRgb pixel = picture.pixel(x, y);
                const bool isFaint = qRed(pixel) == qGreen(pixel) && qRed(pixel) >= 191;
                marked += isFaint ? 0 : 1;
            }
        }
        QVERIFY(marked > 0);
        QVERIFY2(
            result.output.contains("\n1 of 2 " + QByteArray::number(marked).rightJustified(11)),
            result.output.constData());
    }

    void tellsTheSameAsJson()
    {
        const QStringList options = {"--methods", "column-scan:exact,column-scan:float32,truth",
                                     "--limit", "1000000", "--json"};

        const ProgramRun result = compare(tiesScene, options);

        QCOMPARE(result.exitCode, 1);
        const QJsonObject all = QJsonDocument::fromJson(result.output).object();
        const QJsonArray contenders = all["contenders"].toArray();
        QCOMPARE(contenders.size(), 3);
        QCOMPARE(contenders[0].toObject()["arithmetic"].toString(), QStringLiteral("exact"));
        QCOMPARE(contenders[2].toObject()["method"].toString(), QStringLiteral("truth"));
        QCOMPARE(contenders[1].toObject()["differsFrom"].toArray()[0].toInt(),
                 all["differing"].toInt());
        QCOMPARE(all["pixels"].toArray().size(), all["differing"].toInt());
        const QJsonArray agreeing = all["agreeing"].toArray();
        QCOMPARE(agreeing[0].toInt() + agreeing[1].toInt(), all["differing"].toInt());
        int reasons = 0;
        const QJsonObject byReason = all["reasons"].toObject();
        for (const QJsonValue &count : byReason)
            reasons += count.toInt();
        QCOMPARE(reasons, all["differing"].toInt());
        for (const QJsonValue &pixel : all["pixels"].toArray()) {
            QVERIFY(pixel["reason"].toString() != QStringLiteral("agreed"));
            QVERIFY(pixel["agreeing"].toInt() < 3);
        }
    }

    void ofATieEachIsToldAsTheTruthOfItsOwnRule()
    {
        const QStringList options
            = {"--methods", "edge-equations:exact:closed,edge-equations:exact:top-left", "--json"};

        const QJsonArray pixels
            = QJsonDocument::fromJson(compare(tiesScene, options).output)["pixels"].toArray();

        QVERIFY(!pixels.isEmpty());
        for (const QJsonValue &pixel : pixels) {
            QCOMPARE(pixel["reason"].toString(), QStringLiteral("tie rule"));
            QCOMPARE(
                pixel["contenders"][0]["words"].toString(),
                QStringLiteral("as the truth under the rule closed: the sample lies on an edge"));
            QCOMPARE(
                pixel["contenders"][1]["words"].toString(),
                QStringLiteral("as the truth under the rule top-left: the sample lies on an edge"));
        }
    }

    void ofShapesNothingIsSaidThatRoundingAloneDoesNotShow_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("told");
        QTest::newRow("crossings that are stepped")
            << QStringLiteral("polygon-star.json") << QStringLiteral("polygon-parity:float32")
            << QStringLiteral(": float32 rounds the numbers that decide");
        QTest::newRow("no exact arithmetic")
            << QStringLiteral("circles.json") << QStringLiteral("circle-parametric")
            << QStringLiteral(": the method does so, or float64: it has no exact arithmetic to "
                              "tell by");
    }
    void ofShapesNothingIsSaidThatRoundingAloneDoesNotShow()
    {
        QFETCH(QString, file);
        QFETCH(QString, method);
        QFETCH(QString, told);
        const ProgramRun result
            = compare(sceneFile(file), {"--methods", method + QStringLiteral(",truth")});
        QVERIFY2(QString::fromUtf8(result.output).contains(told + u'\n'),
                 result.output.constData());
        QVERIFY(!result.output.contains("cannot hold"));
    }

    void saysTheSameTwice()
    {
        const QStringList options = {"--methods", "column-scan:fixed16.16,truth"};

        QCOMPARE(compare(tiesScene, options).output, compare(tiesScene, options).output);
    }

    void takesWhatIsLeftOutFromTheScene()
    {
        const ProgramRun result = compare(tiesScene, {"--methods", "column-scan,truth:top-left"});

        QVERIFY2(result.output.contains("\n1 column-scan float32 closed "),
                 result.output.constData());
        QVERIFY2(result.output.contains("\n2 truth top-left "), result.output.constData());
    }

    void countsAndNamesWhatAMethodDoesNotDraw()
    {
        const QStringList options = {"--methods", "column-scan:exact,line-dda:exact,truth"};

        const QString text = QString::fromUtf8(compare("-", options, triangleAndLine).output);
        const QJsonValue column = QJsonDocument::fromJson(
            compare("-", options + QStringList{"--json"}, triangleAndLine).output)["contenders"][0];

        QVERIFY2(text.startsWith(QStringLiteral("contender                   pixels  missing  "
                                                "extra  colour  undrawn ")),
                 qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("\n1 does not draw line: ")));
        QVERIFY(text.contains(QStringLiteral("\n2 does not draw triangle: ")));
        QVERIFY(!text.contains(QStringLiteral("\n3 does not draw")));
        QCOMPARE(column["kindsNotDrawn"].toArray(), QJsonArray{"line"});
        QCOMPARE(column["undrawn"], column["differsFrom"][2]);
        QVERIFY(column["undrawn"].toInt() > 0);
    }

    void hasTheTruthThatPixelTells()
    {
        const QByteArray compared
            = compare("-", {"--methods", "column-scan,truth", "--json", "--limit", "1000"},
                      triangleAndLine)
                  .output;
        const QJsonArray pixels = QJsonDocument::fromJson(compared)["pixels"].toArray();
        QVERIFY(pixels.size() > 5);
        for (const QJsonValue &pixel : pixels) {
            const QByteArray told = run({"pixel", "-", QString::number(pixel["x"].toInt()),
                                         QString::number(pixel["y"].toInt()), "--json"},
                                        triangleAndLine)
                                        .output;
            const QJsonDocument history = QJsonDocument::fromJson(told);
            QCOMPARE(history["truth"], pixel["contenders"][1]["colour"]);
            QCOMPARE(history["notDrawn"].toArray(), QJsonArray{"line 1"});
            QVERIFY(pixel["contenders"][0]["words"].toString().contains("line 1"));
        }
    }

    void readsTheSceneFromStandardInput()
    {
        QFile file(defaultScene());
        QVERIFY(file.open(QIODevice::ReadOnly));

        const ProgramRun result
            = compare("-", {"--methods", "truth,column-scan:exact"}, file.readAll());

        QCOMPARE(result.exitCode, 0);
    }

    void refusesAWrongListWithAHint_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QStringList &options, const char *message) {
            QTest::newRow(name) << options << QString::fromUtf8(message);
        };
        row("no list", {},
            "pixelplumb-cli compare: --methods is missing; expected a list such as ");
        row("one", {"--methods", "truth"}, "--methods: 1 contender; expected 2 to 4");
        row("five", {"--methods", "truth,truth,truth,truth,truth"},
            "--methods: 5 contenders; expected 2 to 4");
        row("a name left out", {"--methods", "truth,,column-scan"},
            "--methods: unknown method “”; expected one of truth, ");
        row("method", {"--methods", "truth,colum-scan"},
            "unknown method “colum-scan”; did you mean column-scan?; expected one of truth, ");
        row("arithmetic", {"--methods", "truth,column-scan:float"},
            "unknown arithmetic, fill rule or variant “float”; did you mean float32?");
        row("arithmetic of the truth", {"--methods", "truth:float32,column-scan"},
            "unknown fill rule of the truth “float32”");
        row("rule that the method does not keep", {"--methods", "truth,column-scan:exact:top-left"},
            "cannot keep the fill rule “top-left”");
        row("limit", {"--methods", "truth,truth", "--limit", "few"},
            "--limit: “few” is no whole number; expected 0 or more");
        row("option", {"--method", "truth,truth", "--jsn"}, "did you mean --json?");
    }
    void refusesAWrongListWithAHint()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, message);

        const ProgramRun result = compare(defaultScene(), options);

        QCOMPARE(result.exitCode, 2);
        QCOMPARE(result.output, QByteArray());
        QVERIFY2(QString::fromUtf8(result.messages).contains(message), result.messages.constData());
    }

    void refusesASceneThatItCannotRead()
    {
        const ProgramRun result
            = compare("-", {"--methods", "truth,truth"}, "{ \"pixelplumb\": 2 }");

        QCOMPARE(result.exitCode, 2);
        QVERIFY(!result.messages.isEmpty());
    }
};

PIXELPLUMB_TEST(TestCompareCommand)

} // namespace tst_comparecommand

#include "tst_comparecommand.moc"
