// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/showntext.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

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
const QString hostileName = u"%1 %2 %L3\x1b[31m\u202e\U000e0001\u2028\x7f"_s;

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

/// Names from outside come out as they are, and harm nobody: in JSON, and by the functions that
/// escape them. What is printed of them is in tests/data/transcripts/names.txt.
class TestHostileNames : public QObject {
    Q_OBJECT

private slots:
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
        row("line feed", u"a\nb"_s, "a\\x0ab");
        row("C1", u"\u009b"_s, "\\x9b");
        row("soft hyphen", u"\u00ad"_s, "\\xad");
        row("isolate", u"\u2066"_s, "\\u2066");
        row("tag", u"\U000e0041"_s, "\\U000e0041");
        row("private use", u"\U0010fffd"_s, "\\U0010fffd");
        row("no character", u"\uffff"_s, "\\uffff");
    }
    void charactersAreEscapedByTheirCodes()
    {
        QFETCH(QString, text);
        QFETCH(QString, shown);
        QCOMPARE(escapedControls(text), shown);
        const QString json = QString::fromUtf8(
            escapedJson(QJsonDocument(QJsonObject{{u"text"_s, text}}).toJson()));
        QVERIFY(isShowable(json.toUtf8()));
        QCOMPARE(QJsonDocument::fromJson(json.toUtf8()).object()["text"].toString(), text);
    }

    void aProgramsWordsBeyondTheBasicPlaneAreNotCutInHalf()
    {
        QCOMPARE(shownText(u"\U000e0001a😀b"_s.toUtf8(), 3), u"\uFFFDa😀 …"_s);
    }
};

PIXELPLUMB_TEST(TestHostileNames)

} // namespace tst_hostilenames

#include "tst_hostilenames.moc"
