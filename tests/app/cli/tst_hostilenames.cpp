// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/showntext.h"
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace tst_hostilenames {

using namespace pixelplumb;

namespace {

/// What would be replaced, what steers a terminal, what turns the direction of writing, and what
/// cannot be seen, within the basic plane and beyond.
const QString hostileName = QStringLiteral("%1 %2 %L3\x1b[31m\u202e\U000e0001\u2028\x7f");
const QString shownHostileName = QStringLiteral("%1 %2 %L3\\x1b[31m\\u202e\\U000e0001\\u2028\\x7f");

const QByteArray plainScene = R"({ "pixelplumb": 1, "frame": { "width": 8, "height": 8 },
    "primitives": [ { "triangle": [[0, 0], [7, 0], [0, 5]],
                      "colors": ["#ff0000", "#00ff00", "#0000ff"] } ] })";

bool isShowable(const QByteArray &bytes)
{
    for (const char32_t character : QString::fromUtf8(bytes).toUcs4()) {
        if (!canBeShown(character) && character != U'\n')
            return false;
    }
    return true;
}

} // namespace

/// Names from outside come out as they are, and harm nobody.
class TestHostileNames : public QObject {
    Q_OBJECT

private slots:
    void namesAreWholeAndEscaped_data()
    {
        QTest::addColumn<QStringList>("arguments"); // @: the name
        QTest::addColumn<QByteArray>("content"); // of the file of that name; null: there is none
        QTest::addColumn<int>("exitCode");
        const auto row
            = [](const char *name, const QStringList &arguments, const QByteArray &content,
                 int exitCode) { QTest::newRow(name) << arguments << content << exitCode; };
        row("no such command", {"@"}, {}, 2);
        row("no such option", {"render", "--@"}, {}, 2);
        row("no such scene", {"render", "@", "--ascii"}, {}, 2);
        row("no such method", {"render", defaultScene(), "--ascii", "--method", "@"}, {}, 2);
        row("no whole number", {"pixel", defaultScene(), "@", "1"}, {}, 2);
        row("no scene", {"trace", "@"}, "{}", 2);
        row("sizes differ", {"diff", "@", defaultScene()}, plainScene, 3);
        row("sizes differ, the other way", {"diff", defaultScene(), "@"}, plainScene, 3);
        row("several scenes", {"render", "@", defaultScene(), "--ascii"}, plainScene, 0);
        row("a snapped coordinate", {"render", "@", "--ascii"},
            QByteArray(plainScene).replace("[7, 0]", "[6.3, 0.1]"), 0);
        row("an unknown key", {"render", "@", "--ascii"},
            QByteArray(plainScene).replace("\"frame\"", "\"a%1b\": 1, \"frame\""), 2);
        row("no picture", {"diagnose", "@", "--scene", defaultScene()}, "nonsense", 2);
        row("no assignment", {"grade", ".", "--assignment", "@", "-o", "r"}, "{}", 2);
        row("no submissions",
            {"grade", "@", "--assignment", sceneFile("../assignments/column-scan.json"), "-o", "r"},
            {}, 2);
        row("no cases", {"check", "@"}, "{}", 2);
        row("no such program", {"try", "--scene", defaultScene(), "@"}, {}, 2);
        row("a program that is none", {"counterexample", "column-scan", "program:\"@\""}, {}, 2);
        row("an output without a kind", {"render", defaultScene(), "-o", "@"}, {}, 2);
        row("a trace beside", {"try", "--scene", "@", "true"}, plainScene, 1);
    }
    void namesAreWholeAndEscaped()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, content);
        QFETCH(int, exitCode);
        const QTemporaryDir folder;
        const QString path = folder.filePath(hostileName);
        const bool isFile = !content.isNull();
        if (isFile)
            QVERIFY(!writeFile(path, content));
        arguments.replaceInStrings(QStringLiteral("@"), isFile ? path : hostileName);

        const ProgramRun result = run(arguments);

        const QByteArray told = result.output + result.messages;
        QVERIFY2(result.exitCode == exitCode, told.constData());
        QVERIFY2(isShowable(told), told.constData());
        QVERIFY2(QString::fromUtf8(told).contains(shownHostileName), told.constData());
    }

    void jsonMeansTheSameAndIsShowable()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(hostileName);
        QVERIFY(!writeFile(path, plainScene));

        const ProgramRun result = run({"try", "--json", "--scene", path, "true"});

        QVERIFY2(isShowable(result.output), result.output.constData());
        const QJsonObject report = QJsonDocument::fromJson(result.output).object();
        QCOMPARE(report["trials"].toArray()[0].toObject()["scene"].toString(), path);
    }

    void charactersAreEscapedByTheirCodes_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        const auto same = [](const char *text) {
            QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(text);
        };
        same("plain %1 \\ text");
        same("Žofie Ωmega 日本 😀 5 7/54 · ≤ …");
        const auto row = [](const char *name, const QString &text, const char *shown) {
            QTest::newRow(name) << text << QString::fromUtf8(shown);
        };
        row("line feed", QStringLiteral("a\nb"), "a\\x0ab");
        row("C1", QStringLiteral("\u009b"), "\\x9b");
        row("soft hyphen", QStringLiteral("\u00ad"), "\\xad");
        row("isolate", QStringLiteral("\u2066"), "\\u2066");
        row("tag", QStringLiteral("\U000e0041"), "\\U000e0041");
        row("private use", QStringLiteral("\U0010fffd"), "\\U0010fffd");
        row("no character", QStringLiteral("\uffff"), "\\uffff");
    }
    void charactersAreEscapedByTheirCodes()
    {
        QFETCH(QString, text);
        QFETCH(QString, shown);
        QCOMPARE(escapedControls(text), shown);
        const QString json = QString::fromUtf8(
            escapedJson(QJsonDocument(QJsonObject{{QStringLiteral("text"), text}}).toJson()));
        QVERIFY(isShowable(json.toUtf8()));
        QCOMPARE(QJsonDocument::fromJson(json.toUtf8()).object()["text"].toString(), text);
    }

    void aProgramsWordsBeyondTheBasicPlaneAreNotCutInHalf()
    {
        QCOMPARE(shownText(QStringLiteral("\U000e0001a😀b").toUtf8(), 3),
                 QStringLiteral("\uFFFDa😀 …"));
    }

    void aVeryLongWordIsShortened()
    {
        const ProgramRun result = run({"render", QString(100'000, u'x'), "--ascii"});
        QCOMPARE(result.exitCode, 2);
        QVERIFY(result.messages.size() < 5'000);
    }

    void aVeryLongKeyIsToldOnceAndShortened()
    {
        const QByteArray scene
            = QByteArray(plainScene)
                  .replace("\"frame\"", '"' + QByteArray(5'000'000, 'k') + "\": 1, \"frame\"");

        const ProgramRun result = run({"render", "-", "--ascii"}, scene);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.size() < 2'000, result.messages.constData());
        QVERIFY2(result.messages.count('k') < 80, result.messages.constData());
        QVERIFY(result.messages.contains("unknown key"));
    }
};

PIXELPLUMB_TEST(TestHostileNames)

} // namespace tst_hostilenames

#include "tst_hostilenames.moc"
