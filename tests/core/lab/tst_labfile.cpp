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
        settings.families = {u"own-scene"_s, u"ties"_s};
        settings.contenders = {*labContenderNamed(u"column-scan:float32"_s),
                               *labContenderNamed(u"column-scan:exact:fast"_s)};
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
        QTest::newRow("nothing") << QByteArray() << u"JSON"_s;
        QTest::newRow("cut short") << text.left(text.size() / 2) << u"line "_s;
        QTest::newRow("no object") << QByteArray("[1]") << u"expected"_s;
        QTest::newRow("another kind of file")
            << QByteArray("{ \"pixelplumb\": 1 }") << u"no “pixelplumbLab”"_s;
        QTest::newRow("newer version")
            << replaced(text, "\"pixelplumbLab\": 4", "\"pixelplumbLab\": 7")
            << u"pixelplumbLab: 7; expected 4"_s;
        QTest::newRow("version of another type")
            << replaced(text, "\"pixelplumbLab\": 4", "\"pixelplumbLab\": \"1\"")
            << u"expected 4"_s;
        QTest::newRow("contender without its kernel")
            << QByteArray(text).replace("            \"kernel\": \"plain\",\n", "") << u"kernel"_s;
        QTest::newRow("text for a number")
            << replaced(text, "\"rounds\": 2", "\"rounds\": \"2\"") << u"rounds"_s;
        QTest::newRow("number for a flag")
            << replaced(text, "\"complete\": true", "\"complete\": 1")
            << u"complete: 1; expected true or false"_s;
        QTest::newRow("unknown outcome")
            << replaced(text, "\"outcome\": \"measured\"", "\"outcome\": \"lost\"")
            << u"expected one of pending, measured"_s;
        QTest::newRow("unknown key") << replaced(text, "\"rounds\": 2", "\"laps\": 2") << u"laps"_s;
        QTest::newRow("seed that is no number")
            << replaced(text, "\"18446744073709551615\"", "\"many\"")
            << u"expected a whole number as text"_s;
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
