// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labfile.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_labfile {

using namespace pixelplumb;

namespace {

/// A study with everything that a file can hold: measured and failed rows, times, misses.
const Study &measuredStudy()
{
    static const Study study = [] {
        StudySettings settings;
        settings.ownScene = std::make_shared<const Scene>(defaultSceneIn(Arithmetic::Exact, 2));
        settings.families = {QStringLiteral("own-scene"), QStringLiteral("ties")};
        settings.contenders = {*labContenderNamed(QStringLiteral("column-scan:float32")),
                               *labContenderNamed(QStringLiteral("column-scan:exact:fast"))};
        settings.rounds = 2;
        settings.longestDrawSeconds = 3600; // on any machine
        settings.seed = 18'446'744'073'709'551'615U;
        return runStudy(settings);
    }();
    return study;
}

QByteArray replaced(QByteArray text, const QByteArray &before, const QByteArray &after)
{
    return text.replace(text.indexOf(before), before.size(), after);
}

} // namespace

class TestLabFile : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsRead()
    {
        const QByteArray text = writeStudy(measuredStudy());

        const Result<Study> read = readStudy(text);

        QVERIFY2(bool(read), read ? "" : qPrintable(read.error().message()));
        QVERIFY(measuredStudy().rows[0].firstMiss.has_value());
        QVERIFY(read->rows == measuredStudy().rows);
        QVERIFY(*read == measuredStudy());
        QVERIFY(writeStudy(*read) == text);
    }

    void whatIsNotMeasuredIsNotInTheFile()
    {
        const QByteArray text = writeStudy(measuredStudy());

        QVERIFY(!text.contains("\"gaps\""));
        QVERIFY(text.contains("\"flicker\"") == false);
        QVERIFY(text.contains("\"levels\""));
    }

    void faultsAreNamed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("part");
        const QByteArray text = writeStudy(measuredStudy());
        QTest::newRow("nothing") << QByteArray() << QStringLiteral("JSON");
        QTest::newRow("cut short") << text.left(text.size() / 2) << QStringLiteral("line ");
        QTest::newRow("no object") << QByteArray("[1]") << QStringLiteral("expected");
        QTest::newRow("another kind of file")
            << QByteArray("{ \"pixelplumb\": 1 }") << QStringLiteral("no “pixelplumbLab”");
        QTest::newRow("newer version")
            << replaced(text, "\"pixelplumbLab\": 4", "\"pixelplumbLab\": 7")
            << QStringLiteral("pixelplumbLab: 7; expected 4");
        QTest::newRow("version of another type")
            << replaced(text, "\"pixelplumbLab\": 4", "\"pixelplumbLab\": \"1\"")
            << QStringLiteral("expected 4");
        QTest::newRow("contender without its kernel")
            << QByteArray(text).replace("            \"kernel\": \"plain\",\n", "")
            << QStringLiteral("kernel");
        QTest::newRow("text for a number")
            << replaced(text, "\"rounds\": 2", "\"rounds\": \"2\"") << QStringLiteral("rounds");
        QTest::newRow("number for a flag")
            << replaced(text, "\"complete\": true", "\"complete\": 1")
            << QStringLiteral("complete: 1; expected true or false");
        QTest::newRow("unknown outcome")
            << replaced(text, "\"outcome\": \"measured\"", "\"outcome\": \"lost\"")
            << QStringLiteral("expected one of pending, measured");
        QTest::newRow("unknown key")
            << replaced(text, "\"rounds\": 2", "\"laps\": 2") << QStringLiteral("laps");
        QTest::newRow("seed that is no number")
            << replaced(text, "\"18446744073709551615\"", "\"many\"")
            << QStringLiteral("expected a whole number as text");
    }
    void faultsAreNamed()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, part);

        const Result<Study> read = readStudy(text);

        QVERIFY(!read);
        QVERIFY2(read.error().message().contains(part), qPrintable(read.error().message()));
    }

    void everyLineOfTheCsvHasTheHeadersFields()
    {
        const QList<QByteArray> lines = csvOf(measuredStudy()).trimmed().split('\n');

        QCOMPARE(lines.size(), qsizetype(measuredStudy().rows.size()) + 1);
        const qsizetype fields = lines.front().split(',').size();
        QVERIFY(lines.front().startsWith("contender,family,outcome,remark,"));
        QVERIFY(lines.front().contains("accuracy.tiesMissing"));
        const qsizetype divisions
            = lines.front().split(',').indexOf("cost.operations.span divisions");
        QVERIFY(divisions > 0);
        const auto &operations = measuredStudy().rows[0].cost->operations;
        QCOMPARE(lines[1].split(',').at(divisions).toLongLong(),
                 operations->of(WorkStage::Span, Operation::Division));
        for (const QByteArray &line : lines)
            QCOMPARE(line.split(',').size(), fields);
    }
};

PIXELPLUMB_TEST(TestLabFile)

} // namespace tst_labfile

#include "tst_labfile.moc"
